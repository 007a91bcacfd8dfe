// Rows of data/reference/contact.json as numbers of fifty digits.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchgrip/tests/support/exact.h>

namespace patchgrip::testing {

struct ContactRow {
  double input(const std::string& key) const;
  double input_or(double otherwise, const std::string& key) const;
  Exact output(const std::string& key) const;

  std::map<std::string, std::string> inputs, outputs;
};

std::vector<ContactRow> contact_rows(const std::string& name);

}  // namespace patchgrip::testing
