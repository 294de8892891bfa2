#include "video/encoder.hh"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "video/output_file.hh"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace pongsim::video {

namespace {

struct VideoFormat {
  const char* name;
  AVCodecID codec;
  /// Whether it has a picture for each frame; otherwise frames without one are left out.
  bool isGapless;
};
constexpr std::array<VideoFormat, 3> kVideoFormats{
    {{"mp4", AV_CODEC_ID_H264, false}, {"avi", AV_CODEC_ID_MPEG4, false}, {"ogv", AV_CODEC_ID_THEORA, true}}};
/// Longest gap that is filled [s].
constexpr std::int64_t kLongestGap = 10;

const VideoFormat* formatNamed(const std::string& name) {
  const auto* found = std::ranges::find(kVideoFormats, name, &VideoFormat::name);
  return found == kVideoFormats.end() ? nullptr : found;
}

AVPixelFormat formatOf(Pixels pixels) {
  switch (pixels) {
    case Pixels::kBgr:
      return AV_PIX_FMT_BGR24;
    case Pixels::kGrey:
      return AV_PIX_FMT_GRAY8;
    case Pixels::kGrey16:
      return AV_PIX_FMT_GRAY16LE;
    default:
      return AV_PIX_FMT_RGB24;
  }
}

std::string textOf(int error) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(error, text.data(), text.size());
  return text.data();
}

/// Memory for writing files, as in libavformat's examples [bytes].
constexpr int kBufferSize = 1 << 16;

}  // namespace

bool isVideoFormat(const std::string& format) { return formatNamed(format) != nullptr; }

/// What FFmpeg's libraries have made.
class Encoder::Parts {
 public:
  explicit Parts(OutputFile file) : file_(std::move(file)) {}
  ~Parts() {
    sws_freeContext(scaler_);
    av_packet_free(&packet_);
    av_frame_free(&frame_);
    avcodec_free_context(&codec_);
    if (container_ != nullptr && container_->pb != nullptr) {
      av_freep(&container_->pb->buffer);
      avio_context_free(&container_->pb);
    }
    avformat_free_context(container_);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  Outcome<void> begin(const VideoSettings& settings);
  Outcome<void> add(std::int64_t frame, std::span<const std::uint8_t> image);
  Outcome<void> complete();
  const std::filesystem::path& place() const { return file_.place(); }

 private:
  Outcome<void> openCodec(const VideoSettings& settings, const VideoFormat& format);
  Outcome<void> openContainer(const VideoFormat& format);
  Outcome<void> encode(const AVFrame* frame);
  Outcome<void> failed(int error) const {
    return {"'" + place().string() + "' can't be written: " + (file_.error().empty() ? textOf(error) : file_.error())};
  }

  OutputFile file_;
  AVFormatContext* container_ = nullptr;
  AVCodecContext* codec_ = nullptr;
  AVStream* stream_ = nullptr;
  AVFrame* frame_ = nullptr;
  AVPacket* packet_ = nullptr;
  SwsContext* scaler_ = nullptr;
  bool isGapless_ = false;
  /// Number of the last frame in the file, and how many were left out because a gap was too long.
  std::int64_t last_ = -1;
  std::int64_t skipped_ = 0;
  AVPixelFormat source_ = AV_PIX_FMT_NONE;
  int sourceWidth_ = 0;
  int sourceHeight_ = 0;
};

Outcome<void> Encoder::Parts::begin(const VideoSettings& settings) {
  const VideoFormat* format = formatNamed(settings.format);
  if (format == nullptr) return {"there is no video format '" + settings.format + "'"};
  isGapless_ = format->isGapless;
  if (settings.width < 2 || settings.height < 2) return {"a video has at least 2 x 2 pixels"};
  if (Outcome<void> opened = openCodec(settings, *format); !opened) return opened;
  if (Outcome<void> opened = openContainer(*format); !opened) return opened;
  packet_ = av_packet_alloc();
  frame_ = av_frame_alloc();
  frame_->format = codec_->pix_fmt;
  frame_->width = codec_->width;
  frame_->height = codec_->height;
  if (const int error = av_frame_get_buffer(frame_, 0); error < 0) return failed(error);
  source_ = formatOf(settings.pixels);
  sourceWidth_ = settings.width;
  sourceHeight_ = settings.height;
  scaler_ =
      sws_getContext(codec_->width, codec_->height, source_, codec_->width, codec_->height, codec_->pix_fmt,
                     SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT, nullptr, nullptr, nullptr);
  return scaler_ != nullptr ? Outcome<void>{} : failed(AVERROR(ENOMEM));
}

Outcome<void> Encoder::Parts::openCodec(const VideoSettings& settings, const VideoFormat& format) {
  const AVCodec* codec = avcodec_find_encoder(format.codec);
  if (codec == nullptr) return {"the installed libavcodec has no encoder for " + settings.format};
  codec_ = avcodec_alloc_context3(codec);
  codec_->width = settings.width / 2 * 2;
  codec_->height = settings.height / 2 * 2;
  codec_->time_base = {1, settings.rate};
  codec_->framerate = {settings.rate, 1};
  codec_->bit_rate = settings.bitrate;
  codec_->pix_fmt = AV_PIX_FMT_YUV420P;
  codec_->color_range = AVCOL_RANGE_MPEG;
  codec_->colorspace = AVCOL_SPC_SMPTE170M;
  // the other processors are the simulation's; and the bytes do not depend on their number
  codec_->thread_count = 1;
  codec_->flags |= AV_CODEC_FLAG_BITEXACT;
  const AVOutputFormat* container = av_guess_format(format.name, nullptr, nullptr);
  if (container != nullptr && (container->flags & AVFMT_GLOBALHEADER) != 0) {
    codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  }
  AVDictionary* options = nullptr;
  if (format.codec == AV_CODEC_ID_H264) av_dict_set(&options, "preset", "veryfast", 0);
  const int error = avcodec_open2(codec_, codec, &options);
  av_dict_free(&options);
  return error < 0 ? Outcome<void>{"the images can't be encoded: " + textOf(error)} : Outcome<void>{};
}

Outcome<void> Encoder::Parts::openContainer(const VideoFormat& format) {
  int error = avformat_alloc_output_context2(&container_, nullptr, format.name, nullptr);
  if (error < 0) return failed(error);
  container_->flags |= AVFMT_FLAG_BITEXACT;
  auto* buffer = static_cast<unsigned char*>(av_malloc(kBufferSize));
  container_->pb = avio_alloc_context(
      buffer, kBufferSize, 1, &file_, nullptr,
      [](void* file, std::uint8_t* bytes, int size) {
        return static_cast<OutputFile*>(file)->write({bytes, static_cast<std::size_t>(size)});
      },
      [](void* file, std::int64_t offset, int whence) {
        return static_cast<OutputFile*>(file)->seek(offset, whence & ~AVSEEK_FORCE);
      });
  stream_ = avformat_new_stream(container_, nullptr);
  stream_->time_base = codec_->time_base;
  stream_->avg_frame_rate = codec_->framerate;
  error = avcodec_parameters_from_context(stream_->codecpar, codec_);
  if (error >= 0) error = avformat_write_header(container_, nullptr);
  return error < 0 ? failed(error) : Outcome<void>{};
}

/// @param frame Null: no more come.
Outcome<void> Encoder::Parts::encode(const AVFrame* frame) {
  int error = avcodec_send_frame(codec_, frame);
  while (error >= 0) {
    error = avcodec_receive_packet(codec_, packet_);
    if (error == AVERROR(EAGAIN) || error == AVERROR_EOF) return {};
    if (error < 0) break;
    packet_->stream_index = stream_->index;
    if (packet_->duration == 0) packet_->duration = 1;
    av_packet_rescale_ts(packet_, codec_->time_base, stream_->time_base);
    error = av_interleaved_write_frame(container_, packet_);
    if (error >= 0) error = container_->pb->error;
  }
  return failed(error);
}

Outcome<void> Encoder::Parts::add(std::int64_t number, std::span<const std::uint8_t> image) {
  const int size = av_image_get_buffer_size(source_, sourceWidth_, sourceHeight_, 1);
  if (size < 0 || image.size() < static_cast<std::size_t>(size)) return {"an image has too few pixels"};
  if (isGapless_ && last_ >= 0) {
    const std::int64_t most = kLongestGap * codec_->framerate.num;
    skipped_ += std::max<std::int64_t>(number - skipped_ - last_ - 1 - most, 0);
    while (last_ + 1 < number - skipped_) {
      frame_->pts = ++last_;
      if (Outcome<void> repeated = encode(frame_); !repeated) return repeated;
    }
  }
  // the encoder may still look at the last one
  if (const int error = av_frame_make_writable(frame_); error < 0) return failed(error);
  std::array<std::uint8_t*, 4> planes{};
  std::array<int, 4> steps{};
  av_image_fill_arrays(planes.data(), steps.data(), image.data(), source_, sourceWidth_, sourceHeight_, 1);
  sws_scale(scaler_, planes.data(), steps.data(), 0, codec_->height, frame_->data, frame_->linesize);
  last_ = number - skipped_;
  frame_->pts = last_;
  return encode(frame_);
}

Outcome<void> Encoder::Parts::complete() {
  if (Outcome<void> encoded = encode(nullptr); !encoded) return encoded;
  if (const int error = av_write_trailer(container_); error < 0) return failed(error);
  avio_flush(container_->pb);
  if (container_->pb->error < 0) return failed(container_->pb->error);
  return file_.complete();
}

Encoder::Encoder(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Encoder::~Encoder() = default;

Outcome<std::unique_ptr<Encoder>> Encoder::create(const std::filesystem::path& place, const VideoSettings& settings) {
  // what they would print is in what they return
  av_log_set_level(AV_LOG_QUIET);
  Outcome<OutputFile> file = OutputFile::create(place);
  if (!file) return {{}, file.error};
  auto parts = std::make_unique<Parts>(std::move(*file));
  if (Outcome<void> begun = parts->begin(settings); !begun) return {{}, begun.error};
  return {std::unique_ptr<Encoder>(new Encoder(std::move(parts))), {}};
}

Outcome<void> Encoder::add(std::int64_t frame, std::span<const std::uint8_t> image) {
  return parts_->add(frame, image);
}

Outcome<void> Encoder::complete() { return parts_->complete(); }

const std::filesystem::path& Encoder::place() const { return parts_->place(); }

}  // namespace pongsim::video
