// Writes the sample result: write_sample FOLDER FORMAT

#include <cstdlib>

#include "gnomon/writer.h"
#include "tests/viz/sample_result.h"

int main(int count, char** arguments) {
  if (count != 3) return EXIT_FAILURE;
  const auto format = gnomon::output_format(arguments[2]);
  if (!format) return EXIT_FAILURE;
  const gnomon::SampleResult sample;
  gnomon::write_shadow(sample.result(), arguments[1], {{*format}});
}
