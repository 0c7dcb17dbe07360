#include "TestStub.hpp"
