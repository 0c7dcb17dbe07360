#include <iostream>

#include "limiter/acceleration_limiter.hpp"

int main() { std::cout << limiter::AccelerationLimiter{}.Limit(0.0, 1.0, 0.1) << '\n'; }
