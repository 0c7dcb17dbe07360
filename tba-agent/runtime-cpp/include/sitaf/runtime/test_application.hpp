#pragma once

// The precompiled header with everything that generated test applications include.

#include "sitaf/runtime/stub.hpp"
#include "sitaf/runtime/suite_driver.hpp"
