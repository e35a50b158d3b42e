#include "apps/proof/report/machine.h"

#include <CGAL/version.h>
#include <embree3/rtcore.h>
#include <gmp.h>
#include <mpfi.h>
#include <mpfr.h>
#include <sys/utsname.h>

#include <array>
#include <ctime>
#include <fstream>
#include <thread>

namespace gnomon::report {
namespace {

/// What follows the sign on the first line of a file that begins with the key, without blanks and quotes around it.
std::string value_in(const std::string& file, const std::string& key, char sign) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const std::string value = line.substr(line.find(sign) + 1);
    const std::size_t from = value.find_first_not_of(" \t\""), to = value.find_last_not_of(" \t\"");
    if (from != std::string::npos) return value.substr(from, to - from + 1);
  }
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
  return text.data();
}

std::string kernel() {
  utsname names{};
  return uname(&names) == 0 ? std::string(names.sysname) + ' ' + names.release + ' ' + names.machine : "unknown";
}

std::string compiler() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

std::vector<std::pair<std::string, std::string>> machine() {
  return {{"date", today()},
          {"processor", value_in("/proc/cpuinfo", "model name", ':')},
          {"processor_mhz", value_in("/proc/cpuinfo", "cpu MHz", ':')},
          {"processors", std::to_string(std::thread::hardware_concurrency())},
          {"memory", value_in("/proc/meminfo", "MemTotal", ':')},
          {"system", value_in("/etc/os-release", "PRETTY_NAME", '=')},
          {"kernel", kernel()},
          {"compiler", compiler()},
          {"gnomon", GNOMON_VERSION},
          {"cgal", CGAL_VERSION_STR},
          {"embree", RTC_VERSION_STRING},
          {"gmp", gmp_version},
          {"mpfr", mpfr_get_version()},
          {"mpfi", mpfi_get_version()}};
}

}  // namespace gnomon::report
