// Random grasps whose contacts have linear matrix inequalities, and admissible forces on them.
#pragma once

#include <patchgrip/grasp/lmi.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {

struct LmiDraw {
  std::vector<DrawnContact> contacts;
  std::vector<ContactForce> forces;  // admissible: t at most `share` of what slips
  Vector6 load = Vector6::Zero();    // that they carry

  std::vector<Contact> made() const {
    std::vector<Contact> all;
    for (const DrawnContact& c : contacts) all.push_back(c.contact());
    return all;
  }
};

// Exact patches become soft fingers: elliptic, and where `linear` is asked for linear ones too.
inline LmiDraw draw_lmi(GraspDraws& draws, int count, double share, bool linear) {
  using Model = DrawnContact::Model;
  LmiDraw g;
  for (int i = 0; i < count; ++i) {
    DrawnContact c = draws.contact();
    if (c.model == Model::hertz) c.model = Model::elliptic;
    if (c.model == Model::rectangle) c.model = Model::linear;
    if (c.model == Model::linear && !linear) c.model = Model::elliptic;
    Vector3 v = draws.vector();
    v[2] *= 200;
    const double F = draws.uniform(0.1, 1);
    const ContactForce x{F, -draws.uniform(0, share) * c.mu * F * c.gradient(v)};
    g.load -= c.contact().wrench(x.normal, x.friction);
    g.contacts.push_back(c);
    g.forces.push_back(x);
  }
  return g;
}

}  // namespace patchgrip::grasp
