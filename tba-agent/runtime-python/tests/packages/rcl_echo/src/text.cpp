#include "text.hpp"

std::string answer_to(const std::string & text) {return "heard " + text;}
