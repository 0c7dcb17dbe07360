#pragma once

#include "diagnostic_updater/diagnostic_updater.hpp"
