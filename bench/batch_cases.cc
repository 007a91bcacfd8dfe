#include <patchgrip/bench/batch_cases.h>

#include <algorithm>
#include <cstring>

#include <patchgrip/friction/batch.h>

namespace patchgrip::bench {
namespace {

using friction::HertzDisc;

// Two columns of poles and three of results, in one block of memory.
class Table {
 public:
  explicit Table(const PoleSet& poles) : rows_(poles.x.size()), numbers_(5 * rows_) {
    std::ranges::copy(poles.x, numbers_.begin());
    std::ranges::copy(poles.y, column(1).begin());
  }

  friction::PoleBatch batch() { return {column(0), column(1), column(2), column(3), column(4)}; }
  std::size_t rows() const { return rows_; }
  const std::vector<double>& numbers() const { return numbers_; }

  friction::Wrench wrench(std::size_t row) const {
    return {numbers_[2 * rows_ + row], numbers_[3 * rows_ + row], numbers_[4 * rows_ + row]};
  }

 private:
  std::span<double> column(std::size_t i) { return std::span(numbers_).subspan(i * rows_, rows_); }

  std::size_t rows_;
  std::vector<double> numbers_;
};

Label table_label(std::string method, const Table& table, const std::string& mix) {
  return {std::move(method), static_cast<double>(table.rows()), "hertz_disc", mix};
}

Case batch_case(double radius, const std::shared_ptr<Table>& table, const PoleSet& poles, std::size_t judged) {
  const HertzDisc disc = HertzDisc::of_radius(radius);
  friction::gradient(disc, 1, table->batch());
  std::vector<friction::Wrench> computed;
  for (std::size_t i = 0; i < judged; ++i) computed.push_back(table->wrench(i));
  const Truth truth = power_disc_truth(radius, 1, twists_about(poles.first(judged)));
  return {table_label("batch", *table, poles.mix), worst_error(truth, computed, radius), judged, table->rows(),
          [disc, table] {
            friction::gradient(disc, 1, table->batch());
            benchmark::ClobberMemory();
          }};
}

Case scalar_loop_case(double radius, const std::shared_ptr<Table>& table, const std::string& mix) {
  const HertzDisc disc = HertzDisc::of_radius(radius);
  return {table_label("scalar_loop", *table, mix), {}, 0, table->rows(), [disc, table] {
            const friction::PoleBatch batch = table->batch();
            for (std::size_t i = 0; i < batch.pole_x.size(); ++i) {
              const friction::Wrench g = evaluate(disc, friction::twist_about({batch.pole_x[i], batch.pole_y[i]}, 1));
              batch.force_x[i] = g.fx;
              batch.force_y[i] = g.fy;
              batch.moment[i] = g.m;
            }
            benchmark::ClobberMemory();
          }};
}

Case copy_case(const std::shared_ptr<Table>& table, const std::string& mix) {
  const auto target = std::make_shared<std::vector<double>>(table->numbers().size());
  return {table_label("copy", *table, mix), {}, 0, table->rows(), [table, target] {
            std::memcpy(target->data(), table->numbers().data(), target->size() * sizeof(double));
            benchmark::ClobberMemory();
          }};
}

}  // namespace

Case hertz_batch_case(double radius, const PoleSet& poles, std::size_t judged) {
  return batch_case(radius, std::make_shared<Table>(poles), poles, judged);
}

std::vector<Case> batch_cases() {
  constexpr double radius = 5e-3;  // m
  std::vector<Case> cases;
  for (const std::size_t rows : {small_table, large_table}) {
    const PoleSet poles = mixed_poles(radius, rows);
    const auto table = std::make_shared<Table>(poles);
    cases.push_back(batch_case(radius, table, poles, small_table));
    cases.push_back(scalar_loop_case(radius, table, poles.mix));
    cases.push_back(copy_case(table, poles.mix));
  }
  return cases;
}

}  // namespace patchgrip::bench
