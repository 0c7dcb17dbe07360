// Messages as bytes: plain CDR, little endian, with the encapsulation header (OMG DDS-RTPS, 10.2).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "rosidl_runtime_cpp/bounded_vector.hpp"

namespace sitaf_ros {

using Bytes = std::vector<std::uint8_t>;

template<class T>
struct IsSequence : std::false_type {};
template<class T, class A>
struct IsSequence<std::vector<T, A>> : std::true_type {};
template<class T, std::size_t N, class A>
struct IsSequence<rosidl_runtime_cpp::BoundedVector<T, N, A>> : std::true_type {};

template<class T>
struct IsArray : std::false_type {};
template<class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

class Writer
{
public:
  explicit Writer(Bytes & out)
  : out_(out) {out_.assign({0, 1, 0, 0});}

  template<class T>
  void operator()(const T & value)
  {
    if constexpr (std::is_same_v<T, bool>) {
      out_.push_back(value ? 1 : 0);
    } else if constexpr (std::is_arithmetic_v<T>) {
      align(sizeof(T));
      put(&value, sizeof(T));
    } else if constexpr (std::is_same_v<T, std::string>) {
      (*this)(static_cast<std::uint32_t>(value.size() + 1));
      put(value.c_str(), value.size() + 1);
    } else if constexpr (std::is_same_v<T, std::u16string>) {
      (*this)(static_cast<std::uint32_t>(value.size()));
      put(value.data(), 2 * value.size());
    } else if constexpr (IsSequence<T>::value || IsArray<T>::value) {
      if constexpr (IsSequence<T>::value) {
        (*this)(static_cast<std::uint32_t>(value.size()));
      }
      using Item = typename T::value_type;
      if constexpr (std::is_arithmetic_v<Item> && !std::is_same_v<Item, bool>) {
        if (value.size() > 0) {
          align(sizeof(Item));
          put(value.data(), sizeof(Item) * value.size());
        }
      } else {
        for (const auto & item : value) {
          (*this)(static_cast<const Item &>(item));
        }
      }
    } else {
      T::sitaf_each(value, *this);
    }
  }

private:
  void align(std::size_t size)
  {
    while ((out_.size() - 4) % size != 0) {
      out_.push_back(0);
    }
  }
  void put(const void * data, std::size_t size)
  {
    const auto * bytes = static_cast<const std::uint8_t *>(data);
    out_.insert(out_.end(), bytes, bytes + size);
  }

  Bytes & out_;
};

class Reader
{
public:
  Reader(const std::uint8_t * data, std::size_t size)
  : data_(data), size_(size)
  {
    if (size < 4 || data[0] != 0 || data[1] != 1) {
      throw std::runtime_error("only little-endian CDR is read");
    }
  }

  template<class T>
  void operator()(T & value)
  {
    if constexpr (std::is_same_v<T, bool>) {
      value = *take(1) != 0;
    } else if constexpr (std::is_arithmetic_v<T>) {
      align(sizeof(T));
      std::memcpy(&value, take(sizeof(T)), sizeof(T));
    } else if constexpr (std::is_same_v<T, std::string>) {
      const std::uint32_t size = length();
      const auto * text = reinterpret_cast<const char *>(take(size));
      value.assign(text, size == 0 ? 0 : size - 1);
    } else if constexpr (std::is_same_v<T, std::u16string>) {
      const std::uint32_t size = length();
      const std::uint8_t * text = take(2 * std::size_t{size});
      value.resize(size);
      std::memcpy(value.data(), text, 2 * std::size_t{size});
    } else if constexpr (IsSequence<T>::value || IsArray<T>::value) {
      if constexpr (IsSequence<T>::value) {
        const std::uint32_t size = length();
        if (size > size_ - at_) {
          throw std::runtime_error("the serialized message is too short");
        }
        value.resize(size);
      }
      using Item = typename T::value_type;
      if constexpr (std::is_same_v<Item, bool>) {
        for (std::size_t i = 0; i < value.size(); ++i) {
          value[i] = *take(1) != 0;
        }
      } else if constexpr (std::is_arithmetic_v<Item>) {
        if (value.size() > 0) {
          align(sizeof(Item));
          std::memcpy(value.data(), take(sizeof(Item) * value.size()), sizeof(Item) * value.size());
        }
      } else {
        for (auto & item : value) {
          (*this)(item);
        }
      }
    } else {
      T::sitaf_each(value, *this);
    }
  }

private:
  std::uint32_t length()
  {
    std::uint32_t size = 0;
    (*this)(size);
    return size;
  }
  void align(std::size_t size)
  {
    while ((at_ - 4) % size != 0) {
      ++at_;
    }
  }
  const std::uint8_t * take(std::size_t size)
  {
    if (at_ > size_ || size > size_ - at_) {
      throw std::runtime_error("the serialized message is too short");
    }
    const std::uint8_t * found = data_ + at_;
    at_ += size;
    return found;
  }

  const std::uint8_t * data_;
  std::size_t size_;
  std::size_t at_ = 4;
};

}  // namespace sitaf_ros
