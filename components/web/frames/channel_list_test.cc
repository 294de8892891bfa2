#include "web/frames/channel_list.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace pongsim::web {
namespace {

class NamedChannel final : public OwnChannel {
 public:
  explicit NamedChannel(std::string name) : name_(std::move(name)) {}
  std::string topic() const override { return name_; }
  std::string schemaName() const override { return "x"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>&, std::uint64_t,
                             std::function<std::string(std::uint64_t)>) override {
    return nullptr;
  }
  std::string ask(const std::shared_ptr<void>&, const nlohmann::json&) override { return {}; }

 private:
  std::string name_;
};

TEST(ChannelList, HasWhatHasComeAndNotGone) {
  ChannelList list;
  const auto one = std::make_shared<NamedChannel>("/one"), two = std::make_shared<NamedChannel>("/two");
  const std::uint64_t before = list.version();
  list.add(one);
  list.add(two);
  EXPECT_NE(list.version(), before);
  ASSERT_EQ(list.all().size(), 2U);
  list.remove(*one);
  ASSERT_EQ(list.all().size(), 1U);
  EXPECT_EQ(list.all()[0]->topic(), "/two");
}

}  // namespace
}  // namespace pongsim::web
