! SPDX-License-Identifier: Apache-2.0
! A solver in Fortran: Hertz, the film, load sharing with moments of its own.
!
!   gfortran -O2 -shared -fPIC verification/conformance/subjects/fortran_plugin/solver.f90 -o libsolver.so
!   tribocheck verify --plugin libsolver.so
module solver
  use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_int, c_loc, c_null_char, &
    c_ptr, c_size_t
  implicit none
  private
  public :: plugin_version, plugin_name, answer

  ! tribocheck_plugin.h: the version of the interface, statuses, and the code of a word.
  integer(c_int), parameter :: version = 3, done = 0, not_offered = 1
  integer(c_int), parameter :: greenwood_tripp = 0

  real(c_double), parameter :: pi = 3.14159265358979323846_c_double
  real(c_double), parameter :: film_exponent = 0.14_c_double
  real(c_double), parameter :: least_argument = -10  ! of the moments
  character(kind=c_char), target, save :: own_name(16) = &
    [ 'F', 'o', 'r', 't', 'r', 'a', 'n', ' ', 'e', 'x', 'a', 'm', 'p', 'l', 'e', c_null_char ]

contains

  integer(c_int) function plugin_version() bind(C, name='tribocheck_plugin_version')
    plugin_version = version
  end function

  type(c_ptr) function plugin_name() bind(C, name='tribocheck_plugin_name')
    plugin_name = c_loc(own_name)
  end function

  ! Integral of (s-d)**n phi(s) from d on: with s = d + exp(2t) the trapezoidal rule converges fast.
  elemental real(c_double) function moment(n, d)
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

  subroutine hertz_point(load, effective_modulus, reduced_radius, radius, mean_pressure, &
      peak_pressure, approach)
    real(c_double), intent(in) :: load(:), effective_modulus(:), reduced_radius(:)
    real(c_double), intent(out) :: radius(:), mean_pressure(:), peak_pressure(:), approach(:)
    radius = (3*load*reduced_radius/(4*effective_modulus))**(1.0_c_double/3)
    mean_pressure = load/(pi*radius**2)
    peak_pressure = 1.5_c_double*mean_pressure
    approach = radius**2/reduced_radius
  end subroutine

  elemental real(c_double) function central_film(speed, viscosity, pressure_viscosity, load, &
      effective_modulus, reduced_radius, ellipticity)
    real(c_double), intent(in) :: speed, viscosity, pressure_viscosity, load
    real(c_double), intent(in) :: effective_modulus, reduced_radius, ellipticity
    real(c_double) :: modulus
    modulus = 2*effective_modulus  ! E' of the formula
    central_film = 2.69_c_double*reduced_radius &
      *(viscosity*speed/(modulus*reduced_radius))**0.67_c_double &
      *(pressure_viscosity*modulus)**0.53_c_double &
      *(load/(modulus*reduced_radius**2))**(-0.067_c_double) &
      *(1 - 0.61_c_double*exp(-0.73_c_double*ellipticity))
  end function

  ! The sum of the load shares of asperities and film, less 1; falls as lambda grows.
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

  elemental real(c_double) function shared_film(asperity, lambda0, stiffness, offset)
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

  ! The column of a pointer of C.
  function column(address, count) result(numbers)
    type(c_ptr), intent(in) :: address
    integer(c_size_t), intent(in) :: count
    real(c_double), pointer :: numbers(:)
    call c_f_pointer(address, numbers, [count])
  end function

  logical function is_called(name, text)
    character(kind=c_char), intent(in) :: name(*)
    character(len=*), intent(in) :: text
    integer :: i
    is_called = name(len(text) + 1) == c_null_char
    do i = 1, len(text)
      is_called = is_called .and. name(i) == text(i:i)
      if (name(i) == c_null_char) return
    end do
  end function

  integer(c_int) function answer(name, count, argument, result, status) bind(C, name='tribocheck_function')
    character(kind=c_char), intent(in) :: name(*)
    integer(c_size_t), value :: count
    type(c_ptr), intent(in) :: argument(*), result(*)
    integer(c_int), intent(inout) :: status(count)
    type :: array
      real(c_double), pointer :: of(:)
    end type
    type(array) :: a(7), r(4)
    answer = 1
    if (is_called(name, 'gaussian_moment')) then
      call take(2, 1)
      status = merge(not_offered, done, a(2)%of < least_argument)
      where (status == done) r(1)%of = moment(a(1)%of, a(2)%of)
    else if (is_called(name, 'hertz_point')) then
      call take(3, 4)
      call hertz_point(a(1)%of, a(2)%of, a(3)%of, r(1)%of, r(2)%of, r(3)%of, r(4)%of)
      status = done
    else if (is_called(name, 'hamrock_dowson_central')) then
      call take(7, 1)
      r(1)%of = central_film(a(1)%of, a(2)%of, a(3)%of, a(4)%of, a(5)%of, a(6)%of, a(7)%of)
      status = done
    else if (is_called(name, 'load_sharing')) then
      call take(4, 1)
      status = merge(not_offered, done, a(2)%of - a(4)%of < least_argument)
      where (status == done) r(1)%of = shared_film(nint(a(1)%of), a(2)%of, a(3)%of, a(4)%of)
    else
      answer = 0
    end if
  contains
    subroutine take(arguments, results)
      integer, intent(in) :: arguments, results
      integer :: k
      do k = 1, arguments
        a(k)%of => column(argument(k), count)
      end do
      do k = 1, results
        r(k)%of => column(result(k), count)
      end do
    end subroutine
  end function

end module
