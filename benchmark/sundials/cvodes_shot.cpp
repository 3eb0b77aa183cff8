#include "sundials/cvodes_shot.h"

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <cmath>
#include <stdexcept>

namespace cdpr_kinetostatics {
namespace {

constexpr int kStates = 4;      // alpha, moment, x, y
constexpr int kParameters = 4;  // alpha0, moment0, h, v
constexpr long kMostSteps = 100000;

void require(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(std::string("CVODES: ") + what);
}

// The right-hand side of shot.h, with what its derivatives share: CVODES asks for both at the same state.
struct Slope {
  ShotParameters p;
  double t = 0.0, alpha = 0.0;
  double c = 1.0, s = 0.0, tension = 0.0, shear = 0.0, e = 1.0;

  void at(double t_now, double alpha_now) {
    if (t == t_now && alpha == alpha_now) return;
    t = t_now;
    alpha = alpha_now;
    c = std::cos(alpha);
    s = std::sin(alpha);
    const double v = p.v - p.q * t;
    tension = p.h * c - v * s;
    shear = p.h * s + v * c;
    e = 1.0 + p.eps * tension;
  }
};

int slope(double t, N_Vector y, N_Vector ydot, void* data) {
  Slope& f = *static_cast<Slope*>(data);
  const double* in = NV_DATA_S(y);
  double* out = NV_DATA_S(ydot);
  f.at(t, in[0]);
  out[0] = f.e * in[1];
  out[1] = f.e * f.shear;
  out[2] = f.e * f.c;
  out[3] = f.e * f.s;
  return std::isfinite(out[0]) && std::isfinite(out[1]) ? 0 : 1;
}

int variations(int, double t, N_Vector y, N_Vector, N_Vector* of_state, N_Vector* of_slope, void* data, N_Vector,
               N_Vector) {
  Slope& f = *static_cast<Slope*>(data);
  const double* in = NV_DATA_S(y);
  f.at(t, in[0]);
  for (int j = 0; j < kParameters; ++j) {
    const double* d = NV_DATA_S(of_state[j]);
    double* out = NV_DATA_S(of_slope[j]);
    const double direct_t = j == 2 ? f.c : j == 3 ? -f.s : 0.0;
    const double direct_s = j == 2 ? f.s : j == 3 ? f.c : 0.0;
    const double de = f.p.eps * (direct_t - f.shear * d[0]);
    out[0] = f.e * d[1] + in[1] * de;
    out[1] = f.e * (f.tension * d[0] + direct_s) + f.shear * de;
    out[2] = f.c * de - f.e * f.s * d[0];
    out[3] = f.s * de + f.e * f.c * d[0];
  }
  return 0;
}

int jacobian(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector) {
  Slope& f = *static_cast<Slope*>(data);
  const double* in = NV_DATA_S(y);
  f.at(t, in[0]);
  const double de = -f.p.eps * f.shear;
  SM_ELEMENT_D(matrix, 0, 0) = in[1] * de;
  SM_ELEMENT_D(matrix, 0, 1) = f.e;
  SM_ELEMENT_D(matrix, 1, 0) = f.e * f.tension + f.shear * de;
  SM_ELEMENT_D(matrix, 2, 0) = f.c * de - f.e * f.s;
  SM_ELEMENT_D(matrix, 3, 0) = f.s * de + f.e * f.c;
  return 0;
}

void ignoreMessage(int, const char*, const char*, char*, void*) {}

}  // namespace

class CvodesShot::Memory {
 public:
  explicit Memory(const CvodesSettings& settings)
      : settings_(settings), mode_(settings.staggered ? CV_STAGGERED : CV_SIMULTANEOUS) {
    require(SUNContext_Create(nullptr, &context_), "no context");
    y_ = N_VNew_Serial(kStates, context_);
    require(N_VEnableFusedOps_Serial(y_, SUNTRUE), "no fused operations");
    variations_ = N_VCloneVectorArray(kParameters, y_);
    cvodes_ = CVodeCreate(settings.bdf ? CV_BDF : CV_ADAMS, context_);
    setStart({});
    require(CVodeInit(cvodes_, slope, 0.0, y_), "no memory");
    require(CVodeSetUserData(cvodes_, &slope_), "user data refused");
    require(CVodeSStolerances(cvodes_, 1e-6, 1e-6), "tolerances refused");
    require(CVodeSetErrHandlerFn(cvodes_, ignoreMessage, nullptr), "message handler refused");
    require(CVodeSetMaxNumSteps(cvodes_, kMostSteps), "number of steps refused");
    require(CVodeSensInit(cvodes_, kParameters, mode_, variations, variations_), "no memory for sensitivities");
    require(CVodeSetSensErrCon(cvodes_, settings.error_control), "error control refused");
    if (settings.newton) {
      matrix_ = SUNDenseMatrix(kStates, kStates, context_);
      linear_ = SUNLinSol_Dense(y_, matrix_, context_);
      require(CVodeSetLinearSolver(cvodes_, linear_, matrix_), "linear solver refused");
      require(CVodeSetJacFn(cvodes_, jacobian), "Jacobian refused");
    }
    const auto corrector = [&](int vectors) {
      if (vectors == 1) {
        return settings.newton ? SUNNonlinSol_Newton(y_, context_) : SUNNonlinSol_FixedPoint(y_, 0, context_);
      }
      return settings.newton ? SUNNonlinSol_NewtonSens(vectors, y_, context_)
                             : SUNNonlinSol_FixedPointSens(vectors, y_, 0, context_);
    };
    if (settings.staggered) {
      of_state_ = corrector(1);
      of_variations_ = corrector(kParameters);
      require(CVodeSetNonlinearSolver(cvodes_, of_state_), "corrector refused");
      require(CVodeSetNonlinearSolverSensStg(cvodes_, of_variations_), "corrector of sensitivities refused");
    } else {
      of_state_ = corrector(1 + kParameters);
      require(CVodeSetNonlinearSolverSensSim(cvodes_, of_state_), "corrector refused");
    }
  }

  ~Memory() {
    CVodeFree(&cvodes_);
    SUNNonlinSolFree(of_state_);
    if (of_variations_ != nullptr) SUNNonlinSolFree(of_variations_);
    if (linear_ != nullptr) SUNLinSolFree(linear_);
    if (matrix_ != nullptr) SUNMatDestroy(matrix_);
    N_VDestroyVectorArray(variations_, kParameters);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }

  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  bool shoot(const ShotParameters& parameters, double t0, double t1, const ShotState& start, double tolerance,
             Shot* shot) {
    slope_ = Slope();
    slope_.p = parameters;
    slope_.t = t0 - 1.0;  // nothing is known yet
    setStart(start);
    require(CVodeReInit(cvodes_, t0, y_), "cannot start again");
    require(CVodeSensReInit(cvodes_, mode_, variations_), "cannot start sensitivities again");
    require(CVodeSStolerances(cvodes_, tolerance, tolerance), "tolerances refused");
    double of_variations[kParameters] = {tolerance, tolerance, tolerance, tolerance};
    require(CVodeSensSStolerances(cvodes_, tolerance, of_variations), "tolerances of sensitivities refused");
    require(CVodeSetStopTime(cvodes_, t1), "end refused");
    double reached = t0;
    if (CVode(cvodes_, t1, y_, &reached, CV_NORMAL) < 0) return false;
    require(CVodeGetSens(cvodes_, &reached, variations_), "no sensitivities");
    long evaluations = 0;
    require(CVodeGetNumRhsEvals(cvodes_, &evaluations), "no count of evaluations");
    evaluations_ += evaluations;
    const double* y = NV_DATA_S(y_);
    shot->end = {y[0], y[1], y[2], y[3]};
    for (int j = 0; j < kParameters; ++j) {
      shot->sensitivity.col(j) = Eigen::Map<const Eigen::Vector4d>(NV_DATA_S(variations_[j]));
    }
    return true;
  }

  long evaluations() const { return evaluations_; }

 private:
  void setStart(const ShotState& start) {
    double* y = NV_DATA_S(y_);
    y[0] = start.alpha;
    y[1] = start.moment;
    y[2] = start.x;
    y[3] = start.y;
    for (int j = 0; j < kParameters; ++j) N_VConst(0.0, variations_[j]);
    NV_Ith_S(variations_[0], 0) = 1.0;
    NV_Ith_S(variations_[1], 1) = 1.0;
  }

  const CvodesSettings settings_;
  const int mode_;
  Slope slope_;
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  N_Vector* variations_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver of_state_ = nullptr;
  SUNNonlinearSolver of_variations_ = nullptr;
  void* cvodes_ = nullptr;
  long evaluations_ = 0;
};

CvodesShot::CvodesShot(const CvodesSettings& settings) : memory_(std::make_unique<Memory>(settings)) {}

CvodesShot::~CvodesShot() = default;

bool CvodesShot::shoot(const ShotParameters& parameters, double t0, double t1, const ShotState& start, double tolerance,
                       Shot* shot) {
  return memory_->shoot(parameters, t0, t1, start, tolerance, shot);
}

long CvodesShot::evaluations() const { return memory_->evaluations(); }

}  // namespace cdpr_kinetostatics
