#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ament_index_cpp {

class PackageNotFoundError : public std::out_of_range
{
public:
  explicit PackageNotFoundError(const std::string & name)
  : std::out_of_range("package '" + name + "' not found"), package_name(name) {}
  const std::string package_name;
};

/// The folder of the package under test; others are not there.
inline std::string get_package_share_directory(const std::string & package)
{
  const char * folder = std::getenv(("SITAF_SHARE_" + package).c_str());
  if (folder == nullptr) {
    throw PackageNotFoundError(package);
  }
  return folder;
}
inline std::string get_package_prefix(const std::string & package) {return get_package_share_directory(package);}

}  // namespace ament_index_cpp
