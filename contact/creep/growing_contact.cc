#include <patchgrip/contact/creep/growing_contact.h>
#include <patchgrip/contact/creep/history.h>

namespace patchgrip::contact {

GrowingContact::GrowingContact(const CreepCompliance& compliance)
    : compliance_(compliance), lagged_(compliance.modes().size(), 0.) {}

void GrowingContact::advance(double duration, double force) {
  require_non_negative("duration", duration);
  require_non_negative("force", force);
  double sum = compliance_.instantaneous() * force;
  if (duration > 0) {
    for (std::size_t j = 0; j < lagged_.size(); ++j) {
      const double z = duration / compliance_.modes()[j].time;
      lagged_[j] += (force_ - lagged_[j]) * -std::expm1(-z) + (force - force_) * history::mean_lagged(z);
    }
    impulse_ += duration * (force_ + force) / 2;
  }
  for (std::size_t j = 0; j < lagged_.size(); ++j) sum += compliance_.modes()[j].strength * lagged_[j];
  sum = require_non_negative("load_integral", sum + compliance_.fluidity() * impulse_);
  // Rest is growth, too, but for the rounding of its sum.
  is_growing_ = is_growing_ && sum >= load_integral_ * (1 - 8 * 0x1p-53);
  force_ = force;
  load_integral_ = sum;
}

}  // namespace patchgrip::contact
