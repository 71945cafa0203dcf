// SPDX-License-Identifier: Apache-2.0
// Comforts of the page, which is complete without them. A link opens the closed section that it leads to, a part that
// is wider than the screen says so, a picture can be enlarged (Escape closes it again), the values under the pointer are
// shown, and closed sections are printed open.
"use strict";

function openSection() {
  const target = document.getElementById(location.hash.slice(1));
  const closed = target && (target.closest("details") || target.querySelector("details"));
  if (closed && !closed.open) {
    closed.open = true;
    target.scrollIntoView();
  }
}
addEventListener("hashchange", openSection);
openSection();

function markWide() {
  for (const box of document.querySelectorAll(".scroll"))
    box.classList.toggle("wide", box.scrollWidth > box.clientWidth + 1);
}
addEventListener("resize", markWide);
document.addEventListener("toggle", markWide, true);
markWide();

const shown = document.createElement("output");
shown.className = "values";
shown.hidden = true;
document.body.append(shown);

// The values of the axes under the pointer, by the attribute data-axes, which drawing.py makes.
function values(svg, event) {
  const axes = Object.fromEntries(svg.dataset.axes.split(" ").map((one) => one.split("=")));
  for (const name in axes) axes[name] = Number(axes[name]);
  const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const part = [(point.x - axes.xmin) / (axes.xmax - axes.xmin), (axes.ybot - point.y) / (axes.ybot - axes.ytop)];
  if (part.some((one) => !(one >= 0 && one <= 1))) return "";
  const [x, y] = ["x", "y"].map((name, i) => {
    const low = axes[`axis_${name}min`], high = axes[`axis_${name}max`];
    return axes[`logaxis_${name}`] > 0 ? low * (high / low) ** part[i] : low + (high - low) * part[i];
  });
  return `x = ${x.toPrecision(3)}, y = ${y.toPrecision(3)}`;
}

for (const picture of document.querySelectorAll(".picture")) {
  const svg = picture.querySelector("svg");
  svg.addEventListener("pointermove", (event) => {
    const text = svg.dataset.axes ? values(svg, event) : "";
    shown.hidden = text === "";
    shown.textContent = text;
    shown.style.left = `${Math.min(event.clientX + 14, innerWidth - 190)}px`;
    shown.style.top = `${event.clientY + 16}px`;
  });
  svg.addEventListener("pointerleave", () => { shown.hidden = true; });

  const enlarge = document.createElement("button");
  enlarge.type = "button";
  enlarge.className = "enlarge";
  enlarge.textContent = "Enlarge the picture";
  enlarge.setAttribute("aria-expanded", "false");
  const show = (large) => {
    picture.classList.toggle("large", large);
    enlarge.textContent = large ? "Show the picture in its usual size" : "Enlarge the picture";
    enlarge.setAttribute("aria-expanded", String(large));
    markWide();
  };
  enlarge.addEventListener("click", () => show(!picture.classList.contains("large")));
  addEventListener("keydown", (event) => { if (event.key === "Escape") show(false); });
  picture.after(enlarge);
}

// Paper has no way to open a section: all of them are printed, and those that were closed are closed again.
addEventListener("beforeprint", () => {
  for (const one of document.querySelectorAll("details:not([open])")) {
    one.open = true;
    one.dataset.forPrint = "";
  }
});
addEventListener("afterprint", () => {
  for (const one of document.querySelectorAll("details[data-for-print]")) {
    one.open = false;
    delete one.dataset.forPrint;
  }
});
