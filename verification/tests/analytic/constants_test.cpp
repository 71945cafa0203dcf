// SPDX-License-Identifier: Apache-2.0
// The constants of the model in each number type: equal to the specification's rational number or
// closed form to the last bit, or within 4 ulp if they are computed. A wrong last digit might pass
// the checks of the formulas.
#include <gtest/gtest.h>

#include "support/judge.hpp"
#include "tribo/adhesion.hpp"
#include "tribo/batch.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/liquids.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/moes_line.hpp"
#include "tribo/nijenbanning_venner_moes.hpp"
#include "tribo/onset.hpp"
#include "tribo/rough_faces.hpp"
#include "tribo/roughness.hpp"
#include "tribo/spectral_moments.hpp"
#include "tribo/subsurface_shear.hpp"
#include "tribo/thermal_reduction.hpp"
#include "tribo/two_bodies.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::verification {
namespace {

const Reference root_two = sqrt(Reference(2));
const Reference pi_50("3.14159265358979323846264338327950288419716939937510582");

template <class T>
T fraction(long numerator, long denominator) {
  return static_cast<T>(Reference(numerator) / denominator);
}
template <class T>
Reference ulps(T got, const Reference& exact) {
  return abs(Reference(got) / exact - 1) / Reference(std::numeric_limits<T>::epsilon());
}

template <class T>
class Constants : public testing::Test {};
using Numbers = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(Constants, Numbers);

TYPED_TEST(Constants, OfTheNumberTypesAreTheNearest) {
  using T = TypeParam;
  EXPECT_EQ(pi<T>(), T(pi_50));
  EXPECT_EQ(sqrt_two_pi<T>(), T(sqrt(2 * pi_50)));
  EXPECT_EQ(resolved_exponent<T>(), T((std::numeric_limits<T>::digits - 1) * log(Reference(2))));
}

TYPED_TEST(Constants, OfTheFilmAreThoseOfHamrockAndDowson) {
  using T = TypeParam;
  EXPECT_EQ(ratio<T>(hamrock_dowson_central_law.speed_exponent), fraction<T>(67, 100));
  EXPECT_EQ(ratio<T>(hamrock_dowson_central_law.material_exponent), fraction<T>(53, 100));
  EXPECT_EQ(ratio<T>(hamrock_dowson_central_law.sharing_exponent), fraction<T>(67 - 53, 100));
  const auto exact = [](const Reference& k) {
    return Reference(269) / 100 * (1 - Reference(61) / 100 * exp(-Reference(73) / 100 * k));
  };
  for (const T k : {T(0.5), T(1), T(3)})
    EXPECT_LE(ulps(hamrock_dowson_constant(k), exact(Reference(k))), 4) << "k = " << k;
}

TYPED_TEST(Constants, OfTheInletAreThoseOfCrookAndWolveridge) {
  using T = TypeParam;
  EXPECT_EQ(crook_constant<T>(), T(3 / (4 * root_two)));
  EXPECT_EQ(wolveridge_factor<T>(), fraction<T>(27, 10));
}

TYPED_TEST(Constants, OfRoelandsAreThoseOfTheSpecification) {
  using T = TypeParam;
  EXPECT_EQ(roelands_pressure<T>(), T(196000000));
  EXPECT_EQ(roelands_log_viscosity<T>(), fraction<T>(967, 100));
}

TYPED_TEST(Constants, OfTheRoughContactAreThoseOfHertzOnParaboloids) {
  using T = TypeParam;
  // n = β = σ_s = E* = A_nom = F = 1 leaves only the constant factors.
  const auto of_ones = [](AsperityModel model) {
    const T one = 1;
    return asperity_contact(model, one, one, one, T(0), one, one, one);
  };
  const auto gt = of_ones(AsperityModel::greenwood_tripp);
  const auto gw = of_ones(AsperityModel::greenwood_williamson);
  EXPECT_LE(ulps(gt.stiffness, 16 * root_two * pi_50 / 15), 4);
  EXPECT_LE(ulps(gt.area_factor, pi_50 * pi_50), 4);
  EXPECT_LE(ulps(gt.count_factor, 4 * pi_50), 4);
  EXPECT_LE(ulps(gw.stiffness, Reference(4) / 3), 4);
  EXPECT_LE(ulps(gw.area_factor, pi_50), 4);
  EXPECT_LE(ulps(gw.count_factor, 1), 4);
}

// A contract is a promise to users. Making one wider is therefore a decision and not a repair.
TEST(Contracts, AreNoWiderThanPromised) {
  const auto same = [](const Contract& a, const Contract& b) {
    EXPECT_LE(a.ulp, b.ulp);
    EXPECT_LE(a.ulp_per_condition, b.ulp_per_condition);
  };
  same(gaussian_moment_contract, {1, 0});
  same(log_gaussian_moment_contract, {2, 0});
  same(hertz_contract, {10, 0});
  same(effective_modulus_contract, {6, 0});
  same(reduced_radius_contract, {6, 0});
  same(hertz_ellipse_contract, {1, 0});
  same(hertz_line_contract, {1, 0});
  same(film_contract, {20, 0});
  same(moes_line_contract, {20, 0});
  same(nijenbanning_venner_moes_contract, {60, 0});
  same(gupta_thermal_contract, {8, 4});
  same(density_contract, {2, 0});
  same(barus_contract, {4, 1});
  same(roelands_contract, {8, 4});
  same(astm_d341_contract, {8, 4});
  same(viscosity_index_contract, {8, 4});
  same(carreau_yasuda_contract, {16, 4});
  same(murch_wilson_thermal_contract, {8, 0});
  same(subsurface_shear_contract, {8, 4});
  same(pull_off_contract, {4, 0});
  same(jkr_contract, {6, 4});
  same(plasticity_index_contract, {6, 0});
  same(kogut_etsion_contract, {6, 0});
  same(persson_contract, {6, 0});
  same(patir_cheng_contract, {6, 0});
  same(lambda_ratio_contract, {4, 0});
  same(spectral_moments_contract, {6, 3});
  same(starvation_ratio_contract, {16, 0});
  same(load_sharing_contract, {4, 8.5});
  same(operating_point_contract, {8, 16});
}

TEST(Defaults, AreThoseOfTheSpecification) {
  const Scene scene;
  EXPECT_EQ(scene.surface.summit_plane_offset, 0);
  EXPECT_EQ(scene.surface.offset_planes, 1);
  EXPECT_EQ(scene.bodies.ellipticity, 1);
  EXPECT_EQ(scene.friction.slide_roll_ratio, 1);
  EXPECT_EQ(scene.friction.fluid, FluidShear::eyring);
  EXPECT_EQ(scene.friction.viscosity, ViscosityLaw::barus);
  EXPECT_EQ(scene.supply.kind, SupplyKind::flooded);
  EXPECT_EQ(scene.closures.asperity, AsperityModel::greenwood_tripp);
  EXPECT_EQ(scene.closures.starvation, StarvationClosure::flooded_inlet);
  EXPECT_EQ(scene.closures.damiens_exponent, 3);
  EXPECT_EQ(default_departure, 0.05);
}

}  // namespace
}  // namespace tribo::verification
