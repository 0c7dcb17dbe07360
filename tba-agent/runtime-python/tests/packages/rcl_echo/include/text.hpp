#pragma once

#include <string>

std::string answer_to(const std::string & text);
