# SPDX-License-Identifier: Apache-2.0
"""Computes the outputs of one operating point from the named fields of a scene."""

import films
import friction
import inlet
import solver

OUTPUTS = ("film_flooded", "film", "separation", "film_parameter", "asperity_load_share",
           "fluid_load_share", "real_area_ratio", "summit_count", "friction", "regime", "inlet")


def height_sd(scene):
    return scene["surface.summit_height_sd"]


def plane_offset(scene):
    return scene["surface.offset_planes"] * scene["surface.summit_plane_offset"]


def inlet_film(scene):
    """The thickness of the oil film that reaches the inlet, in m. None means a flooded inlet."""
    if scene.get("supply.inlet_flow") is not None:
        return scene["supply.inlet_flow"] / scene["speed"]
    if scene.get("supply.inlet_film_ratio") is not None:
        return scene["supply.inlet_film_ratio"] * height_sd(scene)
    return scene.get("supply.inlet_film")


def flooded_film(scene, contact):
    oil = scene["speed"], scene["lubricant.viscosity"], scene["lubricant.pressure_viscosity"]
    law, modulus = scene["closures.film"], scene["bodies.effective_modulus"]
    if law in films.LINES:
        return films.line_film(law, *oil, scene["load"] / scene["bodies.length"], modulus, contact.radius)
    given = (*oil, scene["load"], modulus, contact.radius, contact.ellipticity)
    return films.point_film(law, *given) if law in films.POINTS else solver.hamrock_dowson_central(*given)


def sharing_exponent(law):
    """The exponent a - b of the film law in load sharing. None means solver.film_exponent()."""
    row = films.LINES.get(law) or films.POINTS.get(law)
    return row and row[1] - row[2]


def smooth_contact(scene):
    """The radius and the ellipticity k for the film law, and the mean pressure."""
    load, modulus = scene["load"], scene["bodies.effective_modulus"]
    if scene["bodies.reduced_radius"] is not None:
        radius = scene["bodies.reduced_radius"]
        return radius, scene["bodies.ellipticity"], solver.hertz_point(load, modulus, radius)["mean_pressure"]
    radius, length = scene["bodies.radius_x"], scene["bodies.length"]
    if length is not None:
        return radius, 1.0, solver.hertz_line(load / length, modulus, radius)["mean_pressure"]
    ellipse = solver.hertz_ellipse(load, modulus, radius, scene["bodies.radius_y"])
    return radius, ellipse["ellipticity"], ellipse["mean_pressure"]


class Contact:
    """The numbers of a contact that do not depend on the film."""

    def __init__(self, scene):
        load, modulus = scene["load"], scene["bodies.effective_modulus"]
        self.radius, self.ellipticity, self.mean_pressure = smooth_contact(scene)
        self.model = scene["closures.asperity"]
        if scene["bodies.reduced_radius"] is None:
            self.area = load / self.mean_pressure
        else:
            self.area = solver.nominal_area(solver.contact_radius(load, modulus, self.radius))
        self.density, self.sd = scene["surface.summit_density"], height_sd(scene)
        summit_radius = scene["surface.summit_radius"]
        self.roughness = self.density * summit_radius * self.sd
        self.delta = plane_offset(scene)
        self.K = solver.stiffness(self.model, self.density, summit_radius, self.sd, load, modulus,
                                  self.area)
        self.floor = solver.floor_of(self.model, self.K, self.delta)

    def asperities(self, lam):
        """Real area ratio and summit count."""
        d = solver.moment_argument(lam, self.delta)
        return (solver.real_area_ratio(self.model, self.roughness, d),
                solver.summit_count(self.model, self.roughness, self.density, self.area, d))


def friction_fields(scene):
    return {"viscosity_law": scene["friction.viscosity"], "viscosity": scene["lubricant.viscosity"],
            "alpha": scene["lubricant.pressure_viscosity"],
            "eyring_stress": scene["lubricant.eyring_stress"], "fluid": scene["friction.fluid"],
            "speed": scene["speed"], "slide_roll_ratio": scene["friction.slide_roll_ratio"],
            "boundary_coefficient": scene["friction.boundary_coefficient"]}


def starved(scene, film):
    """The ratio of the starved film to the flooded one, and 1 minus this ratio."""
    supply = inlet_film(scene)
    if supply is None:
        return 1.0, 0.0
    return inlet.starved(scene["closures.starvation"], film / supply, scene["closures.damiens_exponent"])


def solve(scene, outputs):
    """The asked outputs, and the reason for each undefined one."""
    contact = Contact(scene)
    model, K, delta, sd = contact.model, contact.K, contact.delta, contact.sd
    flooded = flooded_film(scene, contact) / sd
    exponent = sharing_exponent(scene["closures.film"])
    lam_flooded = solver.load_sharing(model, flooded, K, delta, exponent)
    A, w = solver.shares_of_flooded(model, flooded, K, delta, lam_flooded, exponent)
    ratio, deficit = starved(scene, lam_flooded * sd)
    lam = ratio * lam_flooded
    apart = max(lam, contact.floor)
    if inlet_film(scene) is not None:
        A, w = solver.shares_of_starved(model, K, delta, lam_flooded, w, ratio, deficit)
    area, count = contact.asperities(apart)
    values = {"film_flooded": lam_flooded * sd, "film": lam * sd, "separation": apart * sd,
              "film_parameter": lam, "asperity_load_share": A, "fluid_load_share": w,
              "real_area_ratio": area, "summit_count": count, "regime": solver.regime(A, w),
              "inlet": solver.inlet_state(ratio)}
    undefined = {}
    if apart == 0:  # nothing balances the load
        values["regime"] = "collapsed"
        for name in ("asperity_load_share", "fluid_load_share", "friction"):
            if name in outputs:
                values[name], undefined[name] = None, "the film has collapsed: nothing balances the load"
    elif "friction" in outputs:
        values["friction"] = friction.friction(
            {**friction_fields(scene), "separation": apart * sd, "asperity_share": A, "fluid_share": w,
             "area_ratio": area}, contact.mean_pressure)
    return {name: values[name] for name in OUTPUTS if name in outputs}, undefined
