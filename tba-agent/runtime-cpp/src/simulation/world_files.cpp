#include "simulation/world_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sitaf::simulation {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t maxBytes = 64U << 20U;

}  // namespace

sim::v1::WorldSource readWorld(const std::string& description) {
  const fs::path file = fs::absolute(description).lexically_normal();
  if (!fs::is_regular_file(file)) {
    throw std::runtime_error(description + " is not a file");
  }
  sim::v1::WorldSource world;
  world.set_description(file.filename().string());
  std::uintmax_t total = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(file.parent_path())) {
    if (!fs::is_regular_file(entry.symlink_status())) {
      continue;
    }
    total += entry.file_size();
    if (total > maxBytes) {
      throw std::runtime_error("the files of the world are larger than " + std::to_string(maxBytes) + " bytes");
    }
    std::ifstream stream(entry.path(), std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad() || !stream.is_open()) {
      throw std::runtime_error(entry.path().string() + " cannot be read");
    }
    (*world.mutable_files())[entry.path().lexically_relative(file.parent_path()).generic_string()] = std::move(content);
  }
  return world;
}

}  // namespace sitaf::simulation
