#pragma once

// Everything that a generated test application includes, for one precompiled header.

#include "sitaf/runtime/stub.hpp"
#include "sitaf/runtime/suite_driver.hpp"
