// A fibre that is not round: its section is an ellipse of the area that the round one has, and turns along the fibre.
// One text for view/rendering/software/curve_inl.h (as many strands as there are lanes) and the shader
// strand_shade.comp, with the names that curve_formula.inl asks for.

const float kSectionTwistsPerM = 5.0F; // Turns of a straight fibre's section, 1/m.
const float kOwnSectionRad = 1.7F;     // Greatest angle by which the hairs of a lock are out of step.
const float kSectionLean = 0.9F;

struct Section
{
    Num width; // Width that the eye sees, over a round fibre's.
    Num glint; // Light that it mirrors, over a round fibre's.
    Num lean;  // By how much its scales stand elsewhere, as twice the half angle's sine; see turnedBy().
};

// `axes`: longest over shortest diameter, from 1 on. A coil shows its flat side once a turn, where its lock does.
CURVE_FUNCTION Section sectionAt(Num axes, Num turns, Num lengthM, Num phase, Num chance, Num s)
{
    Num shown = cosOf((turns + lengthM * kSectionTwistsPerM) * (s * 6.28318531F) + phase + chance * kOwnSectionRad);
    // The squared semi-axes are `axes` and 1 over it. Seen from an angle, the ellipse is as wide as its support across
    // that, and mirrors with the radius of curvature of the point that faces the eye: 1 over the support's cube there.
    Num mean = (axes + 1.0F / axes) * 0.5F;
    Num swing = (axes - 1.0F / axes) * 0.5F * shown;
    Section section;
    section.width = root(mean + swing);
    section.glint = 1.0F / ((mean - swing) * root(mean - swing) * section.width);
    section.lean = (1.0F - 1.0F / axes) * kSectionLean * shown;
    return section;
}
