#pragma once

namespace sitaf::runtime {

/// Has stdout, stderr, std::cout, std::cerr and std::clog say from now on which case prints: before the first output of a case stands its
/// mark; a case that prints nothing costs nothing. What is written to the descriptors past them belongs to the case that printed before it.
void markCases();

/// What is printed from now on is printed by this case; 0 for what belongs to none.
void beginCase(int no);

}  // namespace sitaf::runtime
