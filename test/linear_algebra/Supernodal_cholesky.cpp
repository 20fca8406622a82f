#include <Conformal_geometry_processing/linear_algebra/Supernodal_cholesky.h>
#include "linear_algebra/solver_laws.h"
namespace cgp_test { namespace {
using Models = testing::Types<CGP::Supernodal_cholesky<double>, CGP::Supernodal_cholesky<CGP::Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Supernodal, Hermitian_solver, Models);
} }
