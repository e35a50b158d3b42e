#pragma once

#include <stdexcept>

namespace gnomon {

/// A folder does not hold the whole result of one run of ours; what() names the file, and says what is wrong with it.
class ResultError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gnomon
