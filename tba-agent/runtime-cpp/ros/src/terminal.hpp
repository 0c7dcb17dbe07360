#pragma once

#include <string>

namespace sitaf_ros {

/// Adds a line to the standard input of the case.
void add_input(const std::string & line);
/// Whether the node waited for a line, and the case has none.
bool lacks_input();
/// Makes a terminal with these lines the standard input.
void begin_input();

}  // namespace sitaf_ros
