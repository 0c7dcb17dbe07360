// Names of encodings of images, and what they say about a pixel.
#pragma once

#include <stdexcept>
#include <string>

namespace sensor_msgs {
namespace image_encodings {

#define SITAF_ENCODING(name, text) const char name[] = text
SITAF_ENCODING(RGB8, "rgb8");
SITAF_ENCODING(RGBA8, "rgba8");
SITAF_ENCODING(RGB16, "rgb16");
SITAF_ENCODING(RGBA16, "rgba16");
SITAF_ENCODING(BGR8, "bgr8");
SITAF_ENCODING(BGRA8, "bgra8");
SITAF_ENCODING(BGR16, "bgr16");
SITAF_ENCODING(BGRA16, "bgra16");
SITAF_ENCODING(MONO8, "mono8");
SITAF_ENCODING(MONO16, "mono16");
#define SITAF_DEPTH(type) \
  SITAF_ENCODING(TYPE_ ## type ## 1, #type "1"); \
  SITAF_ENCODING(TYPE_ ## type ## 2, #type "2"); \
  SITAF_ENCODING(TYPE_ ## type ## 3, #type "3"); \
  SITAF_ENCODING(TYPE_ ## type ## 4, #type "4")
#define SITAF_DEPTH_C(type) \
  SITAF_ENCODING(TYPE_ ## type ## C1, #type "C1"); \
  SITAF_ENCODING(TYPE_ ## type ## C2, #type "C2"); \
  SITAF_ENCODING(TYPE_ ## type ## C3, #type "C3"); \
  SITAF_ENCODING(TYPE_ ## type ## C4, #type "C4")
SITAF_DEPTH_C(8U);
SITAF_DEPTH_C(8S);
SITAF_DEPTH_C(16U);
SITAF_DEPTH_C(16S);
SITAF_DEPTH_C(32S);
SITAF_DEPTH_C(32F);
SITAF_DEPTH_C(64F);
#undef SITAF_DEPTH
#undef SITAF_DEPTH_C
SITAF_ENCODING(BAYER_RGGB8, "bayer_rggb8");
SITAF_ENCODING(BAYER_BGGR8, "bayer_bggr8");
SITAF_ENCODING(BAYER_GBRG8, "bayer_gbrg8");
SITAF_ENCODING(BAYER_GRBG8, "bayer_grbg8");
SITAF_ENCODING(BAYER_RGGB16, "bayer_rggb16");
SITAF_ENCODING(BAYER_BGGR16, "bayer_bggr16");
SITAF_ENCODING(BAYER_GBRG16, "bayer_gbrg16");
SITAF_ENCODING(BAYER_GRBG16, "bayer_grbg16");
SITAF_ENCODING(UYVY, "uyvy");
SITAF_ENCODING(YUYV, "yuyv");
SITAF_ENCODING(YUV422, "yuv422");
SITAF_ENCODING(YUV422_YUY2, "yuv422_yuy2");
SITAF_ENCODING(NV21, "nv21");
SITAF_ENCODING(NV24, "nv24");
#undef SITAF_ENCODING

inline bool isColor(const std::string & e)
{
  return e == RGB8 || e == BGR8 || e == RGBA8 || e == BGRA8 || e == RGB16 || e == BGR16 || e == RGBA16 ||
         e == BGRA16 || e == NV21 || e == NV24;
}
inline bool isMono(const std::string & e) {return e == MONO8 || e == MONO16;}
inline bool isBayer(const std::string & e) {return e.rfind("bayer_", 0) == 0;}
inline bool hasAlpha(const std::string & e) {return e == RGBA8 || e == BGRA8 || e == RGBA16 || e == BGRA16;}
inline int numChannels(const std::string & e)
{
  if (isMono(e) || isBayer(e)) {
    return 1;
  }
  if (hasAlpha(e)) {
    return 4;
  }
  if (e == NV21 || e == NV24 || e == YUV422 || e == YUV422_YUY2 || e == UYVY || e == YUYV) {
    return 2;
  }
  if (isColor(e)) {
    return 3;
  }
  const auto at = e.find('C');
  const std::string type = e.substr(0, at);
  if (type == "8U" || type == "8S" || type == "16U" || type == "16S" || type == "32S" || type == "32F" || type == "64F") {
    return at == std::string::npos ? 1 : std::stoi(e.substr(at + 1));
  }
  throw std::runtime_error("Unknown encoding " + e);
}
inline int bitDepth(const std::string & e)
{
  if (e == MONO16 || (isBayer(e) && e.size() > 2 && e.substr(e.size() - 2) == "16") || e == RGB16 || e == RGBA16 ||
    e == BGR16 || e == BGRA16)
  {
    return 16;
  }
  if (isColor(e) || isMono(e) || isBayer(e) || e == YUV422 || e == YUV422_YUY2 || e == UYVY || e == YUYV) {
    return 8;
  }
  numChannels(e);
  return std::stoi(e);
}

}  // namespace image_encodings
}  // namespace sensor_msgs
