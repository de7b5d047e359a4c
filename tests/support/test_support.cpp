#include "support/verify.hpp"
