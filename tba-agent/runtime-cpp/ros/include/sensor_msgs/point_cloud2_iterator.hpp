// Makes point clouds, and iterates over one of their fields.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "sensor_msgs/msg/point_cloud2.hpp"

namespace sensor_msgs {

inline int sizeOfPointField(int datatype)
{
  using F = msg::PointField;
  switch (datatype) {
    case F::INT8:
    case F::UINT8:
      return 1;
    case F::INT16:
    case F::UINT16:
      return 2;
    case F::INT32:
    case F::UINT32:
    case F::FLOAT32:
      return 4;
    case F::FLOAT64:
      return 8;
    default:
      throw std::runtime_error("PointField of type " + std::to_string(datatype) + " does not exist");
  }
}

inline int addPointField(msg::PointCloud2 & cloud, const std::string & name, int count, int datatype, int offset)
{
  msg::PointField field;
  field.name = name;
  field.count = static_cast<std::uint32_t>(count);
  field.datatype = static_cast<std::uint8_t>(datatype);
  field.offset = static_cast<std::uint32_t>(offset);
  cloud.fields.push_back(field);
  return offset + count * sizeOfPointField(datatype);
}

class PointCloud2Modifier
{
public:
  explicit PointCloud2Modifier(msg::PointCloud2 & cloud)
  : cloud_(cloud) {}
  std::size_t size() const {return static_cast<std::size_t>(cloud_.width) * cloud_.height;}
  void reserve(std::size_t count) {cloud_.data.reserve(count * cloud_.point_step);}
  void resize(std::size_t count)
  {
    cloud_.data.resize(count * cloud_.point_step);
    if (cloud_.height != 1 && cloud_.width * cloud_.height != count) {
      cloud_.height = 1;
    }
    cloud_.width = cloud_.height == 0 ? static_cast<std::uint32_t>(count) : static_cast<std::uint32_t>(count / cloud_.height);
    cloud_.height = cloud_.height == 0 ? 1 : cloud_.height;
    cloud_.row_step = cloud_.width * cloud_.point_step;
  }
  void clear()
  {
    cloud_.data.clear();
    cloud_.width = cloud_.row_step = 0;
    cloud_.height = 1;
  }
  /// After the number of fields: name, count and type of each.
  void setPointCloud2Fields(int count, ...)
  {
    cloud_.fields.clear();
    int offset = 0;
    va_list given;
    va_start(given, count);
    for (int i = 0; i < count; ++i) {
      const std::string name(va_arg(given, char *));
      const int size = va_arg(given, int), type = va_arg(given, int);
      offset = addPointField(cloud_, name, size, type, offset);
    }
    va_end(given);
    finish(offset);
  }
  /// After the number of texts: `xyz`, `rgb` or `rgba`.
  void setPointCloud2FieldsByString(int count, ...)
  {
    using F = msg::PointField;
    cloud_.fields.clear();
    int offset = 0;
    va_list given;
    va_start(given, count);
    for (int i = 0; i < count; ++i) {
      const std::string name(va_arg(given, char *));
      if (name == "xyz") {
        for (const char * axis : {"x", "y", "z"}) {
          offset = addPointField(cloud_, axis, 1, F::FLOAT32, offset);
        }
        offset += sizeOfPointField(F::FLOAT32);
      } else if (name == "rgb" || name == "rgba") {
        offset = addPointField(cloud_, name, 1, F::FLOAT32, offset);
        offset += 3 * sizeOfPointField(F::FLOAT32);
      } else {
        va_end(given);
        throw std::runtime_error("Field " + name + " does not exist");
      }
    }
    va_end(given);
    finish(offset);
  }

private:
  void finish(int offset)
  {
    cloud_.point_step = static_cast<std::uint32_t>(offset);
    cloud_.row_step = cloud_.width * cloud_.point_step;
    cloud_.data.resize(static_cast<std::size_t>(cloud_.height) * cloud_.row_step);
  }

  msg::PointCloud2 & cloud_;
};

namespace impl {

/// T is the type of the field, or const in a constant cloud.
template<class T, class Cloud>
class FieldIterator
{
  using Byte = std::conditional_t<std::is_const_v<T>, const std::uint8_t, std::uint8_t>;

public:
  FieldIterator() = default;
  FieldIterator(Cloud & cloud, const std::string & name)
  : step_(static_cast<int>(cloud.point_step)), big_endian_(cloud.is_bigendian)
  {
    at_ = cloud.data.data() + offset(cloud, name);
    end_ = cloud.data.data() + static_cast<std::size_t>(cloud.height) * cloud.row_step +
      (at_ - cloud.data.data());
  }
  T & operator*() const {return *reinterpret_cast<T *>(at_);}
  T & operator[](std::size_t i) const {return reinterpret_cast<T *>(at_)[i];}
  FieldIterator & operator++() {return *this += 1;}
  FieldIterator operator++(int)
  {
    FieldIterator before = *this;
    ++*this;
    return before;
  }
  FieldIterator & operator+=(int count)
  {
    at_ += count * step_;
    return *this;
  }
  FieldIterator operator+(int count) const
  {
    FieldIterator made = *this;
    made += count;
    return made;
  }
  bool operator==(const FieldIterator & other) const {return at_ == other.at_;}
  bool operator!=(const FieldIterator & other) const {return at_ != other.at_;}
  FieldIterator end() const
  {
    FieldIterator made = *this;
    made.at_ = end_;
    return made;
  }

private:
  std::size_t offset(const msg::PointCloud2 & cloud, const std::string & name)
  {
    for (const auto & field : cloud.fields) {
      if (field.name == name) {
        return field.offset;
      }
    }
    // The bytes of a colour are named, too.
    const std::string letters = big_endian_ ? "argb" : "bgra";
    const auto place = name.size() == 1 ? letters.find(name) : std::string::npos;
    for (const auto & field : cloud.fields) {
      if (place != std::string::npos && (field.name == "rgb" || field.name == "rgba")) {
        return field.offset + place;
      }
    }
    throw std::runtime_error("Field " + name + " does not exist");
  }

  int step_ = 0;
  bool big_endian_ = false;
  Byte * at_ = nullptr;
  Byte * end_ = nullptr;
};

}  // namespace impl

template<class T>
class PointCloud2Iterator : public impl::FieldIterator<T, msg::PointCloud2>
{
public:
  using impl::FieldIterator<T, msg::PointCloud2>::FieldIterator;
};
template<class T>
class PointCloud2ConstIterator : public impl::FieldIterator<const T, const msg::PointCloud2>
{
public:
  using impl::FieldIterator<const T, const msg::PointCloud2>::FieldIterator;
};

}  // namespace sensor_msgs
