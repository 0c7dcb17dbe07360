#pragma once

namespace sitaf::runtime {

/// Replaces stdout, stderr, std::cout, std::cerr and std::clog by streams that mark which case printed what: the first output of each case
/// follows a mark with its number. Output directly to the descriptors has no mark and is attributed to the previous case that printed.
void markCases();

/// Attributes the following output to a case; 0 for output that belongs to no case.
void beginCase(int no);

}  // namespace sitaf::runtime
