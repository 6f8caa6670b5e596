// Checks of emitted text.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace physgen::test {

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no\n" << part << "\nin\n" << text;
}

}  // namespace physgen::test
