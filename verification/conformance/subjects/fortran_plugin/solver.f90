! SPDX-License-Identifier: Apache-2.0
! A solver in Fortran: Hertz, the film, load sharing with moments of its own.
!
!   gfortran -O2 -shared -fPIC verification/conformance/subjects/fortran_plugin/solver.f90 -o libsolver.so
!   tribocheck verify --plugin libsolver.so
module solver
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_loc, c_null_char, c_ptr, c_size_t
  implicit none
  private
  public :: plugin_version, plugin_name, hertz_point, hamrock_dowson_central, load_sharing, &
            gaussian_moment

  ! tribocheck_plugin.h: the version of the interface, statuses, and the code of a word.
  integer(c_int), parameter :: version = 1, done = 0, not_offered = 1
  integer(c_int), parameter :: greenwood_tripp = 0

  real(c_double), parameter :: pi = 3.14159265358979323846_c_double
  real(c_double), parameter :: film_exponent = 0.14_c_double
  real(c_double), parameter :: least_argument = -10  ! of the moments
  character(kind=c_char), target, save :: name(16) = &
    [ 'F', 'o', 'r', 't', 'r', 'a', 'n', ' ', 'e', 'x', 'a', 'm', 'p', 'l', 'e', c_null_char ]

contains

  integer(c_int) function plugin_version() bind(C, name='tribocheck_plugin_version')
    plugin_version = version
  end function

  type(c_ptr) function plugin_name() bind(C, name='tribocheck_plugin_name')
    plugin_name = c_loc(name)
  end function

  ! Integral of (s-d)**n phi(s) from d on: with s = d + exp(2t) the trapezoidal rule converges fast.
  pure real(c_double) function moment(n, d)
    real(c_double), intent(in) :: n, d
    integer, parameter :: per_unit = 32
    real(c_double) :: t, u, exponent
    integer :: i
    moment = 0
    do i = -20*per_unit, 2*per_unit
      t = real(i, c_double)/per_unit
      u = exp(2*t)
      exponent = merge(u*(d + u/2), (u + d)**2/2, d > 0)
      moment = moment + exp((2*n + 2)*t - exponent)
    end do
    if (d > 0) moment = moment*exp(-d**2/2)
    moment = 2*moment/(per_unit*sqrt(2*pi))
  end function

  subroutine gaussian_moment(count, order, argument, value, status) &
      bind(C, name='tribocheck_gaussian_moment')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: order(count), argument(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    integer(c_size_t) :: i
    do i = 1, count
      status(i) = merge(not_offered, done, argument(i) < least_argument)
      if (status(i) == done) value(i) = moment(order(i), argument(i))
    end do
  end subroutine

  subroutine hertz_point(count, load, effective_modulus, reduced_radius, radius, mean_pressure, &
      peak_pressure, approach, status) bind(C, name='tribocheck_hertz_point')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: load(count), effective_modulus(count), reduced_radius(count)
    real(c_double), intent(out) :: radius(count), mean_pressure(count), peak_pressure(count)
    real(c_double), intent(out) :: approach(count)
    integer(c_int), intent(out) :: status(count)
    radius = (3*load*reduced_radius/(4*effective_modulus))**(1.0_c_double/3)
    mean_pressure = load/(pi*radius**2)
    peak_pressure = 1.5_c_double*mean_pressure
    approach = radius**2/reduced_radius
    status = done
  end subroutine

  subroutine hamrock_dowson_central(count, speed, viscosity, pressure_viscosity, load, &
      effective_modulus, reduced_radius, ellipticity, value, status) &
      bind(C, name='tribocheck_hamrock_dowson_central')
    integer(c_size_t), value :: count
    real(c_double), intent(in) :: speed(count), viscosity(count), pressure_viscosity(count)
    real(c_double), intent(in) :: load(count), effective_modulus(count), reduced_radius(count)
    real(c_double), intent(in) :: ellipticity(count)
    real(c_double), intent(out) :: value(count)
    integer(c_int), intent(out) :: status(count)
    real(c_double) :: modulus(count)
    modulus = 2*effective_modulus  ! E' of the formula
    value = 2.69_c_double*reduced_radius &
      *(viscosity*speed/(modulus*reduced_radius))**0.67_c_double &
      *(pressure_viscosity*modulus)**0.53_c_double &
      *(load/(modulus*reduced_radius**2))**(-0.067_c_double) &
      *(1 - 0.61_c_double*exp(-0.73_c_double*ellipticity))
    status = done
  end subroutine

  ! What asperities and film carry, less the load; it falls with the film.
  pure real(c_double) function excess(asperity, lambda, lambda0, stiffness, offset)
    integer(c_int), intent(in) :: asperity
    real(c_double), intent(in) :: lambda, lambda0, stiffness, offset
    real(c_double) :: share
    if (asperity == greenwood_tripp) then
      share = sqrt(stiffness*moment(2.5_c_double, lambda - offset))
    else
      share = stiffness*moment(1.5_c_double, lambda - offset)
    end if
    excess = share + (lambda0/lambda)**(1/film_exponent) - 1
  end function

  pure real(c_double) function shared_film(asperity, lambda0, stiffness, offset)
    integer(c_int), intent(in) :: asperity
    real(c_double), intent(in) :: lambda0, stiffness, offset
    real(c_double) :: low, high
    integer :: i
    low = lambda0
    high = lambda0 + offset + 1
    do while (excess(asperity, high, lambda0, stiffness, offset) > 0 .and. high < 1e6_c_double)
      high = 2*high
    end do
    do i = 1, 60
      shared_film = (low + high)/2
      if (excess(asperity, shared_film, lambda0, stiffness, offset) > 0) then
        low = shared_film
      else
        high = shared_film
      end if
    end do
  end function

  subroutine load_sharing(count, asperity, flooded_film_parameter, stiffness, offset, value, status) &
      bind(C, name='tribocheck_load_sharing')
    integer(c_size_t), value :: count
    integer(c_int), intent(in) :: asperity(count)
    real(c_double), intent(in) :: flooded_film_parameter(count), stiffness(count), offset(count)
    real(c_double), intent(inout) :: value(count)
    integer(c_int), intent(out) :: status(count)
    integer(c_size_t) :: i
    do i = 1, count
      status(i) = merge(not_offered, done, flooded_film_parameter(i) - offset(i) < least_argument)
      if (status(i) == done) &
        value(i) = shared_film(asperity(i), flooded_film_parameter(i), stiffness(i), offset(i))
    end do
  end subroutine

end module
