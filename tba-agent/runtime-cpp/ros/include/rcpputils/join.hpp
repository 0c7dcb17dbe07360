#pragma once

#include <iterator>
#include <sstream>
#include <string>

namespace rcpputils {

template<class C>
std::string join(const C & container, const std::string & delimiter)
{
  std::ostringstream out;
  bool first = true;
  for (const auto & item : container) {
    out << (first ? "" : delimiter) << item;
    first = false;
  }
  return out.str();
}

}  // namespace rcpputils
