// The arguments of a node's main function.
#pragma once

namespace sitaf_ros {

/// How many there are; the first is the name of the program.
inline int & argument_count()
{
  static int count = 1;
  return count;
}

/// The arguments, with a null pointer behind the last one.
inline char ** & arguments()
{
  static char name[] = "node";
  static char * only_name[] = {name, nullptr};
  static char ** all = only_name;
  return all;
}

}  // namespace sitaf_ros
