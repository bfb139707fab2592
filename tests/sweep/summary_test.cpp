// Statistics and sensitivity indices, compared with known ones.
#include "plan_folder.h"

#include "sweep/summary.h"

#include <cmath>

namespace cairn::test {
namespace {

class SweepSummary : public PlanFolder {
  protected:
    // Ishigami's function of three angles, whose sensitivity indices are known in closed form.
    sweep::Summary ishigami(const std::string& sample) {
        write_scene();
        plan_ = plan("\"sample\": " + sample + R"json(, "seconds": 0.0042,
            "parameters": [{"name": "a", "from": -3.14159265358979, "to": 3.14159265358979},
                           {"name": "b", "from": -3.14159265358979, "to": 3.14159265358979},
                           {"name": "c", "from": -3.14159265358979, "to": 3.14159265358979}],
            "measure": [{"name": "y", "of": "sin(a) + 7 * sin(b)^2 + 0.1 * c^4 * sin(a)"
    },
                        {"name": "flat", "of": "4"}])json");
        sweep::Summary summary(plan_);
        const sweep::Start start = sweep::load_start(plan_);
        sweep::Runner runner(plan_, start);
        std::vector<double> numbers(plan_.numbers());
        const std::atomic<bool> never{false};
        for (std::uint64_t row = 0; row < plan_.design.rows(); ++row) {
            runner.run(row, numbers, never);
            summary.add(row, numbers);
        }
        return summary;
    }
    sweep::Plan plan_;
};

TEST_F(SweepSummary, SobolIndicesAreThoseOfIshigamisFunction) {
    const sweep::Summary summary = ishigami("{\"sensitivity\": 2048}");
    const double first[]{0.3139, 0.4424, 0.0}, total[]{0.5576, 0.4424, 0.2437};
    for (std::size_t p = 0; p < 3; ++p) {
        const sweep::Sensitivity s = summary.sensitivity(p, 0);
        EXPECT_NEAR(s.first, first[p], 0.03) << p;
        EXPECT_NEAR(s.total, total[p], 0.03) << p;
        EXPECT_LT(s.first_error, 0.1);
        EXPECT_GT(s.first_error, 0.0);
    }
    EXPECT_TRUE(std::isnan(summary.sensitivity(0, 1).first)) << "what never changes has no variance to share";
}

TEST_F(SweepSummary, FirstIndicesComeFromAnyRows) {
    const double first[]{0.3139, 0.4424, 0.0};
    for (const std::string sample : {"{\"random\": 8000, \"seed\": 5}", "{\"sobol\": 8000}"}) {
        const sweep::Summary summary = ishigami(sample);
        for (std::size_t p = 0; p < 3; ++p) {
            EXPECT_NEAR(summary.sensitivity(p, 0).first, first[p], 0.03) << sample << p;
            EXPECT_TRUE(std::isnan(summary.sensitivity(p, 0).total));
        }
    }
}

TEST_F(SweepSummary, MeansAndDeviationsAreThoseOfTheNumbersThereAre) {
    write_scene();
    plan_ = plan(R"json("parameters": [{"name": "a", "values": [1, 2, 4, 9]}], "seconds": 0.0042,
        "measure": [{"name": "y", "of": "a"}, {"name": "z", "of": "sqrt(a - 2)"
}])json");
    sweep::Summary summary(plan_);
    const std::vector<Row> rows = rows_of(plan_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row& row = rows[i];
        summary.add(i, std::vector<double>{row.at("a"), row.at("y"), row.at("z"), row.at("time"), row.at("outcome")});
    }
    const std::vector<sweep::ColumnSummary> columns = summary.columns();
    ASSERT_EQ(columns.size(), 3u);
    EXPECT_EQ(columns[1].count, 4u);
    EXPECT_NEAR(columns[1].mean, 4.0, 1e-15);
    EXPECT_NEAR(columns[1].deviation, std::sqrt((9.0 + 4.0 + 0.0 + 25.0) / 3.0), 1e-14);
    EXPECT_EQ(columns[2].count, 3u);
    EXPECT_EQ(columns[2].min, 0.0);
    EXPECT_NEAR(columns[2].max, std::sqrt(7.0), 1e-15);
    EXPECT_EQ(summary.count(sweep::Outcome::ran), 4u);
}

} // namespace
} // namespace cairn::test
