// Reference tables against the library: how wrong is it, and what does it not cover yet?
//
// A table is a JSON file in the format of data/reference/friction.json. Every entry that the library covers is
// evaluated and compared in 50 digits; kinds of entries and fields that it does not cover are named, never passed over.
//
// Scale of an error    force mu F_N; moment mu F_N a_K; S, D, a_K, centroid and second moment their own size (the
//                      centroid the radius of gyration); a Hessian its largest entry, with the spin rows divided by a
//                      length of the patch. Lines called "relative" compare with the size of the value itself.
// Rounded inputs       a table states poles, twists and sizes as decimals, the library takes the nearest doubles. The
//                      errors are printed with that in them, and beside them the worst that is left without it
//                      (inputs.h). The smaller of the two is held against the tolerance, since a table may mean either.
// Stated accuracy      trajectories whose entry states an accuracy of its own (`tolerance`, `solver_agreement`) may be
//                      wrong by as much more.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace patchgrip::cli {

// Prints to `out`, per table and kind: entries, worst and mean error as a number and in units of 2^-53. Returns 0; or 1
// if an error exceeds `tolerance`, or anything is not covered unless `allow_uncovered`. Throws TableError (node.h)
// where a table cannot be read: exit code 2 of the program.
int run_accuracy(const std::vector<std::string>& tables, double tolerance, bool allow_uncovered, std::ostream& out);

}  // namespace patchgrip::cli
