// EXPECT: conversion from .*(hertz|unit\)1)|no viable conversion
#include <drivecodec/core/quantity.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;

#ifdef OK
constexpr quantity<unit::second> ramp = 50_s;
#else
constexpr quantity<unit::second> ramp = 50_Hz;
#endif
