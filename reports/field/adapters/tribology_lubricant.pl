# SPDX-License-Identifier: Apache-2.0
# Asks Tribology::Lubricant by Sherzod Ruzmetov, a module for Perl, in cSt and degrees Celsius.
use strict;
use warnings;
use JSON::PP;
use lib "$ENV{FIELD_SOURCE}/lib";
use Tribology::Lubricant;

my %functions = (
    viscosity_index => sub {
        my ($q) = @_;
        return Tribology::Lubricant->new({visc40 => 1e6 * $q->{kinematic_viscosity_40}, visc100 => 1e6 * $q->{kinematic_viscosity_100}})->vi;
    },
    astm_d341_viscosity => sub {
        my ($q) = @_;
        my $oil = Tribology::Lubricant->new({});
        $oil->visc($q->{"${_}_temperature"} - 273.15, 1e6 * $q->{"${_}_viscosity"}) for qw(first second);
        return 1e-6 * $oil->visc($q->{temperature} - 273.15);
    },
);
my $json = JSON::PP->new->canonical;
$| = 1;
while (my $line = <STDIN>) {
    my $q = $json->decode($line);
    my $function = $functions{$q->{function} // ""};
    my $value = $function ? eval { $function->($q) } : undef;
    my %result = $function ? ($@ ? (error => "$@") : (value => 0 + $value)) : (skip => "it is not offered here");
    print $json->encode({id => $q->{id}, %result}), "\n";
}
