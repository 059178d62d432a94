// ceres_fit.cc - adapts the fit to Ceres.
//
// All residuals of a point are computed together, before Ceres requests each of them.
// No exception leaves this file.

#include "rt/study/fit/ceres_fit.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <vector>

#include <ceres/ceres.h>
#include <glog/logging.h>

namespace
{

void require(bool good, const char *message)
{
    if (!good)
        throw std::runtime_error(message);
}

// The residuals and derivatives at one point. The function of the problem computes
// them.
class Evaluation : public ceres::EvaluationCallback
{
  public:
    Evaluation(const ceres_problem &problem, const double *values)
        : problem_(problem), values_(values), residuals_(problem.residuals),
          derivatives_(problem.residuals * problem.values)
    {
    }

    void PrepareForEvaluation(bool derivatives, bool) override
    {
        good_ = problem_.evaluate(problem_.context, values_, residuals_.data(),
                                  derivatives ? derivatives_.data() : nullptr);
    }

    bool good() const
    {
        return good_;
    }
    size_t values() const
    {
        return problem_.values;
    }
    double residual(size_t i) const
    {
        return residuals_[i];
    }
    const double *derivatives(size_t i) const
    {
        return &derivatives_[i * problem_.values];
    }

  private:
    const ceres_problem &problem_;
    const double *values_;
    std::vector<double> residuals_, derivatives_;
    bool good_ = false;
};

class Residual : public ceres::CostFunction
{
  public:
    Residual(const Evaluation &evaluation, size_t i) : evaluation_(evaluation), i_(i)
    {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(
            static_cast<int>(evaluation.values()));
    }

    bool Evaluate(double const *const *, double *residuals,
                  double **jacobians) const override
    {
        residuals[0] = evaluation_.residual(i_);
        if (jacobians && jacobians[0])
            std::copy_n(evaluation_.derivatives(i_), evaluation_.values(),
                        jacobians[0]);
        return evaluation_.good();
    }

  private:
    const Evaluation &evaluation_;
    size_t i_;
};

void add_residuals(ceres::Problem &problem, const ceres_problem &given,
                   const Evaluation &evaluation, double *values)
{
    for (size_t i = 0; i < given.residuals; i++) {
        const double loss = given.losses[i];
        problem.AddResidualBlock(new Residual(evaluation, i),
                                 loss > 0 ? new ceres::CauchyLoss(loss) : nullptr,
                                 values);
    }
}

void set_bounds(ceres::Problem &problem, const ceres_problem &given, double *values)
{
    for (size_t i = 0; i < given.values; i++) {
        values[i] = std::min(std::max(values[i], given.least[i]), given.most[i]);
        const int place = static_cast<int>(i);
        problem.SetParameterLowerBound(values, place, given.least[i]);
        problem.SetParameterUpperBound(values, place, given.most[i]);
    }
}

bool find_covariance(ceres::Problem &problem, const double *values, double *covariance)
{
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    options.null_space_rank = 0;
    ceres::Covariance found(options);
    const std::vector<const double *> blocks{ values };
    return found.Compute(blocks, &problem)
           && found.GetCovarianceBlock(values, values, covariance);
}

void fit(const ceres_problem &given, double *values, ceres_outcome &outcome)
{
    require(given.values > 0 && given.residuals > 0, "nothing to fit");
    Evaluation evaluation(given, values);
    ceres::Problem::Options how;
    how.evaluation_callback = &evaluation;
    ceres::Problem problem(how);
    add_residuals(problem, given, evaluation, values);
    set_bounds(problem, given, values);

    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 50;
    options.function_tolerance = 1e-4;
    options.parameter_tolerance = 1e-6;
    options.num_threads = 1;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    require(summary.IsSolutionUsable(), summary.message.c_str());
    outcome.cost = summary.final_cost;
    outcome.steps = static_cast<int>(summary.iterations.size()) - 1;
    outcome.converged = summary.termination_type == ceres::CONVERGENCE;
    std::snprintf(outcome.message, sizeof outcome.message, "%s",
                  summary.message.c_str());
    outcome.determined = find_covariance(problem, values, outcome.covariance);
}

void quiet()
{
    static const bool begun = [] {
        FLAGS_logtostderr = true;
        FLAGS_minloglevel = google::GLOG_FATAL;
        google::InitGoogleLogging("fit205");
        return true;
    }();
    (void)begun;
}

} // namespace

extern "C" bool ceres_fit(const ceres_problem *problem, double *values,
                          ceres_outcome *outcome)
{
    try {
        quiet();
        fit(*problem, values, *outcome);
        return true;
    } catch (const std::exception &caught) {
        std::snprintf(outcome->message, sizeof outcome->message, "%s", caught.what());
    } catch (...) {
        std::snprintf(outcome->message, sizeof outcome->message, "unknown error");
    }
    return false;
}
