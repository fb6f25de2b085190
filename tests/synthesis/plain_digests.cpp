// Prints what every primitive gives, compiled without vector instructions.

#include "field_digest.hpp"

int main() {
  std::fputs(verdigris::field_digests().c_str(), stdout);
}
