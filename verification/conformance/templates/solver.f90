! A solver for tribocheck in Fortran. It skips everything: fill in values and set their status to done,
! or take out the procedures that you do not have. Arguments, units and ranges: tribocheck_plugin.h.
!
!   gfortran -O2 -shared -fPIC solver.f90 -o libsolver.so
!   tribocheck verify --plugin libsolver.so
module solver
  use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t
  implicit none

  integer(c_int), parameter :: version = 1  ! TRIBOCHECK_PLUGIN_VERSION
  integer(c_int), parameter :: done = 0, not_offered = 1, undefined = 2, failed = 3

  type, bind(C) :: scene_type  ! tribocheck_scene
    real(c_double) :: load, summit_density, summit_radius, summit_height_sd, summit_plane_offset
    real(c_double) :: effective_modulus, reduced_radius, ellipticity
    real(c_double) :: viscosity, pressure_viscosity, eyring_stress, supply_value
    real(c_double) :: boundary_coefficient, slide_roll_ratio, damiens_exponent
    integer(c_int) :: offset_planes, supply, asperity, starvation, fluid, viscosity_law
  end type

  type, bind(C) :: point_type  ! tribocheck_point
    real(c_double) :: film_flooded, film, separation, film_parameter
    real(c_double) :: asperity_load_share, fluid_load_share, real_area_ratio, summit_count, friction
    integer(c_int) :: regime, inlet
  end type

contains

  integer(c_int) function plugin_version() bind(C, name='tribocheck_plugin_version')
    plugin_version = version
  end function

  subroutine gaussian_moment(count, order, argument, value, status) &
      bind(C, name='tribocheck_gaussian_moment')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: order(count), argument(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered  ! value = my_moment(order, argument); status = done
  end subroutine

  subroutine hertz_point(count, load, effective_modulus, reduced_radius, radius, mean_pressure, &
      peak_pressure, approach, status) bind(C, name='tribocheck_hertz_point')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: load(count), effective_modulus(count), reduced_radius(count)
    real(c_double), intent(inout) :: radius(count), mean_pressure(count), peak_pressure(count)
    real(c_double), intent(inout) :: approach(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered
  end subroutine

  subroutine hamrock_dowson_central(count, speed, viscosity, pressure_viscosity, load, &
      effective_modulus, reduced_radius, ellipticity, value, status) &
      bind(C, name='tribocheck_hamrock_dowson_central')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: speed(count), viscosity(count), pressure_viscosity(count)
    real(c_double), intent(in) :: load(count), effective_modulus(count), reduced_radius(count)
    real(c_double), intent(in) :: ellipticity(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered
  end subroutine

  subroutine starvation_ratio(count, closure, flooded_over_inlet, damiens_exponent, value, status) &
      bind(C, name='tribocheck_starvation_ratio')
    integer(c_size_t), value :: count
    integer(c_int), intent(in) :: closure(count)
    real(c_double), intent(in) :: flooded_over_inlet(count), damiens_exponent(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered
  end subroutine

  subroutine load_sharing(count, asperity, flooded_film_parameter, stiffness, offset, value, status) &
      bind(C, name='tribocheck_load_sharing')
    integer(c_size_t), value :: count
    integer(c_int), intent(in) :: asperity(count)
    real(c_double), intent(in) :: flooded_film_parameter(count), stiffness(count), offset(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered
  end subroutine

  subroutine operating_point(scene, count, speed, point, status) &
      bind(C, name='tribocheck_operating_point')
    type(scene_type), intent(in) :: scene
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: speed(count)
    type(point_type), intent(inout) :: point(count)
    integer(c_int), intent(out) :: status(count)
    status = not_offered  ! point%film = my_film(scene, speed); status = done
  end subroutine

end module
