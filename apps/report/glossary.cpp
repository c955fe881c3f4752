// The terms of the report page, as docs/glossary.md has them.
#include <fmt/format.h>
#include <array>

#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"
#include "apps/text/markup.hpp"

namespace output {
namespace {

struct Term {
  const char* name;
  const char* meaning;  ///< word for word that of docs/glossary.md
};

constexpr std::array terms{
    Term{"ITZ",
         "Interfacial transition zone: the thin, weak layer of mortar around each aggregate. Drawn as a ring "
         "of "
         "pixels, or as extra points."},
    Term{"material point", "The piece of material of one pixel. It carries mass, stress and damage."},
    Term{"ghost point", "A material point that has failed: it keeps its mass and carries no stress."},
    Term{"platen (smooth, rough)",
         "The plate that loads the specimen at the top or supports it at the bottom. Smooth: free to slide "
         "sideways. Rough: no sideways motion."},
    Term{"platen strain, stress",
         "Displacement of the top platen over the height; mean reaction of both platens over the width."},
    Term{"Weibull scale, modulus",
         "The two parameters of the random strengths. 63.2 % of the points are weaker than the scale; a "
         "larger "
         "modulus means less scatter."},
    Term{"seed",
         "The number that fixes all random draws. Another seed is another specimen, or other strengths, of "
         "the "
         "same kind."},
    Term{"tension, shear failure",
         "Largest principal stress above the tensile strength; Mohr-Coulomb criterion with cohesion and "
         "friction angle."},
    Term{"crack closure",
         "A point that failed in tension carries compression again when its crack closes. Off by default."},
    Term{"fracture energy",
         "Energy that a crack takes per area [J/m²]. Without it a point loses all its stress at once."},
    Term{"crack band",
         "The width over which a crack is smeared. A phase with a fracture energy softens in it, so that the "
         "energy of a crack does not depend on the pixel size."},
    Term{"small strain",
         "Kinematics in which points keep their place. Fast; valid until the specimen falls apart."},
    Term{"moving points",
         "Kinematics in which points move through the grid: large deformation, fragments, impact."},
    Term{"USF, USL, MUSL",
         "When a step updates the stress: first, last, or last with velocities mapped back to the nodes. For "
         "moving points."},
    Term{"FLIP, PIC, APIC",
         "How points take their velocity from the nodes: its change, its value, or its value and gradient."},
    Term{"linear, GIMP, B-spline",
         "Shape functions of moving points: how a point spreads over the nodes around it."},
    Term{"time step, CFL number",
         "The CFL number is the time step over the time that the fastest wave takes to cross a cell."},
    Term{"energy ledger",
         "The balance of a run: work of the platens = kinetic + elastic + released + damped energy + energy "
         "of "
         "points that left. Its largest error is energy_error."},
};

}  // namespace

std::string glossary_section() {
  std::string html = "<details>\n<summary>The terms of this page</summary>\n<dl>\n";
  for (const Term& term : terms)
    html += fmt::format("<dt>{}</dt>\n<dd>{}</dd>\n", escape(term.name), escape(term.meaning));
  return section("Glossary",
                 html + "</dl>\n<p>More terms are in docs/glossary.md of mesopix.</p>\n</details>\n");
}

}  // namespace output
