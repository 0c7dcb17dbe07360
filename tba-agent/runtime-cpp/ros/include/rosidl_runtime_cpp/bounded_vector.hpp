#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <vector>

namespace rosidl_runtime_cpp {

/// A vector with a maximum size.
template<class T, std::size_t Bound, class Allocator = std::allocator<T>>
class BoundedVector : protected std::vector<T, Allocator>
{
  using Base = std::vector<T, Allocator>;

public:
  using typename Base::value_type;
  using typename Base::size_type;
  using typename Base::reference;
  using typename Base::const_reference;
  using typename Base::iterator;
  using typename Base::const_iterator;
  using Base::begin;
  using Base::end;
  using Base::cbegin;
  using Base::cend;
  using Base::rbegin;
  using Base::rend;
  using Base::size;
  using Base::empty;
  using Base::clear;
  using Base::data;
  using Base::front;
  using Base::back;
  using Base::at;
  using Base::operator[];
  using Base::pop_back;
  using Base::erase;
  using Base::capacity;

  BoundedVector() = default;
  explicit BoundedVector(std::size_t count, const T & value = T())
  : Base(check(count), value) {}
  BoundedVector(std::initializer_list<T> items)
  : Base(items) {check(items.size());}
  BoundedVector(const Base & items)
  : Base(items) {check(items.size());}
  template<class I, class = typename std::iterator_traits<I>::iterator_category>
  BoundedVector(I first, I last)
  : Base(first, last) {check(size());}

  size_type max_size() const {return Bound;}
  void reserve(std::size_t count) {Base::reserve(check(count));}
  void resize(std::size_t count) {Base::resize(check(count));}
  void resize(std::size_t count, const T & value) {Base::resize(check(count), value);}
  void push_back(const T & item) {check(size() + 1); Base::push_back(item);}
  template<class ... Args>
  auto & emplace_back(Args && ... args) {check(size() + 1); return Base::emplace_back(std::forward<Args>(args)...);}
  void assign(std::size_t count, const T & value) {Base::assign(check(count), value);}
  template<class I>
  void assign(I first, I last) {Base::assign(first, last); check(size());}
  template<class ... Args>
  auto insert(Args && ... args)
  {
    auto found = Base::insert(std::forward<Args>(args)...);
    check(size());
    return found;
  }
  operator const Base &() const {return *this;}

  friend bool operator==(const BoundedVector & a, const BoundedVector & b)
  {
    return static_cast<const Base &>(a) == static_cast<const Base &>(b);
  }
  friend bool operator!=(const BoundedVector & a, const BoundedVector & b) {return !(a == b);}

private:
  static std::size_t check(std::size_t count)
  {
    if (count > Bound) {
      throw std::length_error("Exceeded upper bound");
    }
    return count;
  }
};

}  // namespace rosidl_runtime_cpp
