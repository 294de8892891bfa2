#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

namespace pongsim::test {

/// What a player shows of a video file, decoded by FFmpeg's libraries.
struct DecodedVideo {
  struct Frame {
    /// When it is shown [s].
    double time;
    /// Mean of red, green and blue.
    std::array<double, 3> color;
  };
  std::string codec;
  int width = 0;
  int height = 0;
  std::vector<Frame> frames;
};

inline std::array<double, 3> meanColor(const AVFrame& frame) {
  const auto format = static_cast<AVPixelFormat>(frame.format);
  SwsContext* const scaler =
      sws_getContext(frame.width, frame.height, format, frame.width, frame.height, AV_PIX_FMT_RGB24,
                     SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr);
  const int step = 3 * frame.width;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(step) * static_cast<std::size_t>(frame.height));
  std::uint8_t* const plane = pixels.data();
  sws_scale(scaler, frame.data, frame.linesize, 0, frame.height, &plane, &step);
  sws_freeContext(scaler);
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < pixels.size(); ++i) sum[i % 3] += pixels[i];
  for (double& each : sum) each /= static_cast<double>(pixels.size()) / 3;
  return sum;
}

/// Fails the test where the file can't be played.
inline DecodedVideo decodedVideo(const std::filesystem::path& file) {
  DecodedVideo video;
  AVFormatContext* container = nullptr;
  if (avformat_open_input(&container, file.c_str(), nullptr, nullptr) < 0) {
    ADD_FAILURE() << file << " is no video";
    return video;
  }
  EXPECT_GE(avformat_find_stream_info(container, nullptr), 0);
  const AVStream& stream = *container->streams[0];
  const AVCodec* const decoder = avcodec_find_decoder(stream.codecpar->codec_id);
  video.codec = avcodec_get_name(stream.codecpar->codec_id);
  video.width = stream.codecpar->width;
  video.height = stream.codecpar->height;
  AVCodecContext* codec = avcodec_alloc_context3(decoder);
  avcodec_parameters_to_context(codec, stream.codecpar);
  EXPECT_GE(avcodec_open2(codec, decoder, nullptr), 0);
  AVPacket* packet = av_packet_alloc();
  AVFrame* frame = av_frame_alloc();
  const auto takeFrames = [&] {
    while (avcodec_receive_frame(codec, frame) >= 0) {
      video.frames.push_back(
          {static_cast<double>(frame->best_effort_timestamp) * av_q2d(stream.time_base), meanColor(*frame)});
    }
  };
  while (av_read_frame(container, packet) >= 0) {
    EXPECT_GE(avcodec_send_packet(codec, packet), 0);
    av_packet_unref(packet);
    takeFrames();
  }
  avcodec_send_packet(codec, nullptr);
  takeFrames();
  av_frame_free(&frame);
  av_packet_free(&packet);
  avcodec_free_context(&codec);
  avformat_close_input(&container);
  return video;
}

}  // namespace pongsim::test
