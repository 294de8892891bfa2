#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/entity_wrench.pb.h>

#include "msgs/types/type_source.hh"

namespace pongsim::msgs {

const TypeSource& typeSource() {
  static const TypeSource source = [] {
    // The calls make the linker keep the libraries whose static initializers register all types.
    (void)ignition::msgs::Empty::descriptor();
    (void)ignition::msgs::EntityWrench::descriptor();
    return TypeSource{*google::protobuf::DescriptorPool::generated_pool(),
                      *google::protobuf::DescriptorPool::internal_generated_database(),
                      *google::protobuf::MessageFactory::generated_factory()};
  }();
  return source;
}

}  // namespace pongsim::msgs
