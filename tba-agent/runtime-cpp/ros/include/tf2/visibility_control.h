#pragma once

#include "tf2/linear_math.hpp"
