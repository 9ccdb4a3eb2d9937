// The drawn curve of one strand along its skeleton: Catmull-Rom, the rotation-minimising frame (double reflection, Wang
// et al. 2008), equation 1 (curl) and equation 3 (braid) of Hernandez and Rudomin 2004. One text for strand_curve.cpp
// (a strand of floats), view/rendering/software/curve_inl.h (as many strands as there are lanes) and the shader
// strand_expand.comp: read as C++ and as GLSL, so without references and templates.
//
// Whoever includes it has defined the types Num, Vec3 and Flag (yes or no), CURVE_FUNCTION before each function, the
// numbers of curve_constants.h, and the arithmetic: vec3Of, dot, select, everywhere (whether a Flag is yes for all),
// least, most, clamped, mixed, root, floored, sinOf, cosOf, over (a number by a constant), unitOf (a vector and its
// squared length) and reflectedIn (a vector, in the plane across another of that squared length). They round as each
// always did: pictures and exported files keep their bytes. What each has of its own is how it steps along the strand
// and how it adds the offsets.

const float kTiny = 1e-16F; // A squared length of nothing.

// Catmull-Rom between p1 and p2. Lengths are by node.
struct Span
{
    Vec3 start, c1, c2, c3;
};

CURVE_FUNCTION Span spanOf(Vec3 p0, Vec3 p1, Vec3 p2, Vec3 p3)
{
    Span span;
    span.start = p1;
    span.c1 = (p2 - p0) * 0.5F;
    span.c2 = p0 - p1 * 2.5F + p2 * 2.0F - p3 * 0.5F;
    span.c3 = (p3 - p0) * 0.5F + (p1 - p2) * 1.5F;
    return span;
}

CURVE_FUNCTION Vec3 positionAt(Span span, Num t)
{
    return span.start + (span.c1 + (span.c2 + span.c3 * t) * t) * t;
}

CURVE_FUNCTION Vec3 derivativeAt(Span span, Num t)
{
    return span.c1 + (span.c2 * 2.0F + span.c3 * (t * 3.0F)) * t;
}

// The node beyond `end` where there is none: the curve goes on straight.
CURVE_FUNCTION Vec3 beyond(Vec3 end, Vec3 before)
{
    return end * 2.0F - before;
}

// The same for hair that lies taut on a round head, whose curve goes on bending.
CURVE_FUNCTION Vec3 beyondBent(Vec3 end, Vec3 before, Vec3 beforeThat)
{
    return (end - before) * 3.0F + beforeThat;
}

// A derivative at unit length, or the tangent before it where it has no direction.
CURVE_FUNCTION Vec3 tangentOf(Vec3 derivative, Vec3 lastTangent)
{
    Num squared = dot(derivative, derivative);
    return select(squared > kTiny, unitOf(derivative, squared), lastTangent);
}

// `reference` at unit length in the plane across a unit tangent, or any vector there.
CURVE_FUNCTION Vec3 across(Vec3 reference, Vec3 tangent)
{
    Vec3 v = reference - tangent * dot(reference, tangent);
    Num squared = dot(v, v);
    Flag isClear = squared > 1e-8F;
    if (everywhere(isClear))
        return unitOf(v, squared);
    Flag isSteep = tangent.x * tangent.x < 0.49F;
    Vec3 axis = vec3Of(select(isSteep, 1.0F, 0.0F), select(isSteep, 0.0F, 1.0F), 0.0F);
    Vec3 chosen = select(isClear, v, axis - tangent * dot(axis, tangent));
    return unitOf(chosen, dot(chosen, chosen));
}

// One step of the double reflection: carries `reference` from one point and tangent to the next.
CURVE_FUNCTION Vec3 carried(Vec3 reference, Vec3 lastPoint, Vec3 lastTangent, Vec3 point, Vec3 tangent)
{
    Vec3 onward = point - lastPoint;
    Num squared = dot(onward, onward);
    Vec3 reflected = reflectedIn(reference, onward, squared);
    Vec3 turn = tangent - reflectedIn(lastTangent, onward, squared);
    Num turnSquared = dot(turn, turn);
    Vec3 turned = reflectedIn(reflected, turn, turnSquared);
    return select(squared > kTiny, select(turnSquared > kTiny, turned, reflected), reference);
}

// Equation 1's t at fraction s of the hair: the phase at the root, and `turns` to the tip.
CURVE_FUNCTION Num curlAngle(Num phase, Num turns, Num s)
{
    return phase + turns * kFullTurn * s;
}

// Equation 1 without its linear part, in units of the radius.
CURVE_FUNCTION Vec3 curlOffset(Num t)
{
    Num c = cosOf(t);
    Num s = sinOf(t);
    return vec3Of(c, s, c * s);
}

// Radius of the curl at fraction s of the hair: it grows from 0 at the root.
CURVE_FUNCTION Num curlRadius(Num radiusM, Num s)
{
    return radiusM * least(Num(1.0F), over(s, kCurlEaseFraction));
}

// A hair of a group whose curls are measured in metres (sim::CurlSettings): a helix, or where flat an S along the
// frame's first axis.
struct CoiledHair
{
    Num turns;
    Num radiusM;
    Num phase;  // Its lock's phase, rad: from it follow the lock's hand and where its switchbacks lie.
    Num chance; // -1..1, the hair's own: its phase out of step, and which turns it leaps over.
    Num lengthM;
};

// What tells coily hair from a spring (Darke and Kim 2024): the same for a group.
struct CoilTraits
{
    Num inStepFromM;
    Num switchbacksPerM;
    Num skips;
    Num flatness;
    Num uncoil;
    Num straightM;
};

CURVE_FUNCTION Num partOf(Num x)
{
    return x - floored(x);
}

// Offset from the strand's axis at fraction s of the hair, m: along the frame's first axis and the second.
CURVE_FUNCTION Vec3 coilOffset(CoiledHair hair, CoilTraits traits, Num s)
{
    Num alongM = hair.lengthM * s;
    // Weight draws the turns near the root apart; their number stays.
    Num uncoil = traits.uncoil * least(Num(1.0F), hair.lengthM * (1.0F / kUncoiledM));
    Num tightness = 1.0F - uncoil + uncoil * s * 2.0F;
    Num run = hair.turns * s * (1.0F - uncoil + uncoil * s);
    Num turn = floored(run);
    // Leaps over a turn, and is in step again after it.
    Num part = run - turn;
    Num leap =
        select(partOf(hair.chance * kOwnSkipFactor + turn * kGoldenSection) < traits.skips, Num(1.0F), Num(0.0F));
    // All turns begin at one angle, so that another hand leaves a kink and no gap.
    Num switched = floored(partOf(hair.phase * kSwitchFactor) +
                           turn * traits.switchbacksPerM * hair.lengthM / most(hair.turns, Num(1e-3F)));
    Num hands = switched * 0.5F + select(partOf(hair.phase * kHandFactor) < 0.5F, Num(0.0F), Num(0.5F));
    Num hand = 1.0F - partOf(hands) * 4.0F; // 1 or -1
    // Hairs of a lock are out of step up to half of inStepFromM, and come into step from there to its end.
    Num astray = clamped((traits.inStepFromM - alongM) * 2.0F / most(traits.inStepFromM, Num(1e-6F)), 0.0F, 1.0F);
    Num own = partOf(hair.chance * kOwnPhaseFactor + 0.5F) - 0.5F;
    Num angle = hair.phase + (hand * part * (1.0F - leap) + own * astray) * kFullTurn;
    // The fibre of a turn keeps its length: where turns are drawn apart, they are narrow.
    Num winding = hair.radiusM * hair.turns * kFullTurn / most(hair.lengthM, Num(1e-4F));
    Num open = 1.0F / most(winding * winding, Num(0.01F));
    Num apart = 1.0F / most(tightness, Num(0.05F));
    Num narrow = root(clamped(1.0F + open - open * apart * apart, 0.0F, 2.25F));
    Num easeM =
        most(most(Num(kCoilEaseM), hair.lengthM * 0.25F / most(hair.turns, Num(1e-3F))), hair.radiusM * kCoilEaseRadii);
    easeM = most(least(easeM, hair.lengthM * kCurlEaseFraction), Num(1e-6F));
    Num straightM = least(traits.straightM, hair.lengthM * kMostStraightFraction);
    Num eased = clamped((alongM - straightM) / easeM, 0.0F, 1.0F);
    Num radiusM = hair.radiusM * narrow * eased * eased * (3.0F - eased * 2.0F) *
                  (1.0F + leap * part * (1.0F - part) * (4.0F * kSkipLeap));
    return vec3Of(cosOf(angle) * radiusM, sinOf(angle) * radiusM * (1.0F - traits.flatness), Num(0.0F));
}

// How the wisps of a kind of braid (sim::BraidKind) run: each swings once across its width and `swings` times through
// its thickness in a turn, so that of two that cross one is always above; pathX and pathZ are how far, wisp a wisp's
// radius, in units of r.
struct Lacing
{
    Num wisps, swings;
    Num pathX, pathZ;
    Num wisp;
    Num roomTurns; // A wisp's greatest radius along the braid.
};

CURVE_FUNCTION Num ofKind(Num kind, Num plait, Num twist, Num loc, Num four, Num five, Num fishtail, Num coil)
{
    return select(
        kind < 1.5F, plait,
        select(kind < 2.5F, twist,
               select(kind < 3.5F, loc,
                      select(kind < 4.5F, four, select(kind < 5.5F, five, select(kind < 6.5F, fishtail, coil))))));
}

CURVE_FUNCTION Lacing lacingOf(Num kind)
{
    Lacing lacing;
    lacing.wisps = ofKind(kind, Num(3.0F), Num(2.0F), Num(1.0F), Num(4.0F), Num(5.0F), Num(kFishtailWisps), Num(1.0F));
    lacing.swings = ofKind(kind, Num(2.0F), Num(1.0F), Num(2.0F), Num(3.0F), Num(4.0F), Num(2.0F), Num(1.0F));
    lacing.pathX = ofKind(kind, Num(1.0F), Num(kTwistFraction), Num(0.0F), Num(kFourWide), Num(kFiveWide),
                          Num(kFishtailWide), Num(1.0F));
    lacing.pathZ = ofKind(kind, Num(1.0F), Num(kTwistFraction), Num(0.0F), Num(kFourThick), Num(kFiveThick),
                          Num(kFishtailThick), Num(1.0F));
    // That of a coil follows from its turns: see coilGirth().
    lacing.wisp = ofKind(kind, Num(kWispRadiusFraction), Num(kTwistWispFraction), Num(kLocWispFraction), Num(kFourWisp),
                         Num(kFiveWisp), Num(kFishtailWisp), Num(0.0F));
    lacing.roomTurns = ofKind(kind, Num(kPlaitRoomTurns), Num(kTwistRoomTurns), Num(kPlaitRoomTurns),
                              Num(kPlaitRoomTurns), Num(kPlaitRoomTurns), Num(kPlaitRoomTurns), Num(kPlaitRoomTurns));
    return lacing;
}

// A hair of a braid.
struct BraidedHair
{
    Num radiusM;      // r
    Num turns;        // From where the hair joins the braid to its end.
    Num begun;        // Turns of the braid before that point.
    Num wispX, wispY; // The hair's position in its wisp, in units of the wisp's radius.
    Num chance;       // -1..1, the hair's own: where it ends in the tuft.
    Num taper;        // 0..1: fraction by which r is smaller at the end.
    Num tied;         // 0..1: how far the braid is drawn together before its tuft.
};

// Where a fraction s of the strand lies in a braid that begins at `start`: 0..1.
CURVE_FUNCTION Num braidFraction(Num s, Num start)
{
    return clamped((s - start) / most(1.0F - start, Num(1e-6F)), 0.0F, 1.0F);
}

// Where a fraction s lies in the part that curls, which begins at `start`: behind the ring of gathered hair, else at
// the root, where it is s itself.
CURVE_FUNCTION Num curledFraction(Num s, Num start)
{
    return braidFraction(s, start);
}

// A braid's length, from its derivative's length by node.
CURVE_FUNCTION Num braidLength(Num perNodeM, Num spans, Num start)
{
    return perNodeM * spans * most(1.0F - start, Num(1e-6F));
}

// Thickness of a braid at a fraction q of it.
struct BraidGirth
{
    Num tuft;  // 0..1 over the tuft, or a coil's end.
    Num pathM; // Radius of the wisps' path,
    Num wispM; // and of a wisp.
};

CURVE_FUNCTION BraidGirth braidGirth(BraidedHair hair, Lacing lacing, Num q)
{
    Num parted = least(q * hair.turns * (1.0F / kBraidEaseTurns), Num(1.0F));
    Num r = hair.radiusM * mixed(Num(kBraidFirstFraction), Num(1.0F), parted) * (1.0F - hair.taper * q);
    Num wispR = hair.radiusM * mixed(Num(kWispFirstFraction), Num(1.0F), parted) * (1.0F - hair.taper * q);
    Num tie = clamped(over(q - (1.0F - kTuftFraction - kTieFraction), kTieFraction), 0.0F, 1.0F);
    Flag isOne = lacing.wisps < 1.5F;
    Num tied = select(isOne, Num(0.0F), tie * tie * (3.0F - tie * 2.0F) * hair.tied);
    BraidGirth girth;
    girth.tuft = select(isOne, Num(0.0F), over(most(q - (1.0F - kTuftFraction), Num(0.0F)), kTuftFraction));
    Num opened = least(over(girth.tuft, kTuftOpens), Num(1.0F));
    opened = opened * opened * (3.0F - opened * 2.0F); // Smooth, since a hair has no corner.
    Num narrowed = most(over(girth.tuft - kTuftOpens, 1.0F - kTuftOpens), Num(0.0F));
    narrowed = narrowed * narrowed * (2.0F - narrowed);
    girth.pathM = r * mixed(Num(1.0F), Num(kTieBraidFraction), tied) * (1.0F - opened);
    // A single wisp made of all; where wisps are finer than a plait's of three, it is as thick as one of those.
    Num whole = most(lacing.wisp, lacing.pathX * kWispRadiusFraction);
    Num open = mixed(lacing.wisp * mixed(Num(1.0F), Num(kTieWispFraction), tied), whole * kTuftWispFraction,
                     opened * (2.0F - opened));
    girth.wispM = wispR * mixed(open, whole * kTuftTipFraction, narrowed);
    return girth;
}

// The rope that a bun is wound of: a turn beside the other from the foot of a dome to its top, where it ends in its
// middle. The axis stands in the dome, and the hair goes along it by the sine of q's angle: see GatheredLay::layCoil().
CURVE_FUNCTION BraidGirth coilGirth(BraidedHair hair, Num q)
{
    // Its turns lie side by side over the dome's meridian.
    Num wisp = kCoilMeridian / (kCoilMeridian + hair.turns * kCoilApart);
    Num outward = least(q * hair.turns * (1.0F / kCoilEaseTurns), Num(1.0F));
    Num ends = most(over(q - (1.0F - kCoilEndFraction), kCoilEndFraction), Num(0.0F));
    ends = ends * ends * (3.0F - ends * 2.0F);
    Num path = (1.0F - wisp) * cosOf(q * (0.25F * kFullTurn));
    BraidGirth girth;
    girth.tuft = ends;
    girth.pathM = hair.radiusM * path * outward * (2.0F - outward) * (1.0F - ends);
    girth.wispM =
        hair.radiusM * wisp * mixed(Num(kCoilFirstWisp), Num(1.0F), outward) * (1.0F - ends * (1.0F - kCoilTipWisp));
    return girth;
}

// Fraction of its offset that a hair has, by the spans behind the last node before its braid: it comes to its wisp
// late, since at that node it still lies on the skin.
CURVE_FUNCTION Num gatheredPart(Num spans)
{
    Num part = least(spans, Num(1.0F));
    return part * part;
}

// Equation 3 without its linear part, in units of r, and how it goes on by a radian. x along the frame's first axis, z
// along the third.
struct WispPath
{
    Num x, z;
    Num onwardX, onwardZ;
};

CURVE_FUNCTION WispPath wispPath(Lacing lacing, Num angle)
{
    WispPath path;
    path.x = cosOf(angle) * lacing.pathX;
    path.z = sinOf(angle * lacing.swings) * lacing.pathZ;
    path.onwardX = 0.0F - sinOf(angle) * lacing.pathX;
    path.onwardZ = lacing.swings * cosOf(angle * lacing.swings) * lacing.pathZ;
    return path;
}

// Offset from the strand's axis of a hair in one wisp of a braid, at fraction q of the braidM metres that the hair goes
// in it: along the frame's first axis, the strand, and the third.
CURVE_FUNCTION Vec3 braidedOffset(BraidedHair hair, Num kind, Num wisp, Num q, Num braidM)
{
    // From here on turns, q and braidM are those of the whole braid.
    Num whole = hair.turns + hair.begun;
    q = q + (1.0F - q) * hair.begun / most(whole, Num(1e-3F));
    braidM = braidM * (1.0F + hair.begun / most(hair.turns, Num(1e-3F)));
    hair.turns = whole;
    Lacing lacing = lacingOf(kind);
    Flag isLaced = kind < 6.5F;
    Num twist = Num(kWispTwist);
    BraidGirth girth = braidGirth(hair, lacing, q);
    if (!everywhere(isLaced)) {
        BraidGirth coil = coilGirth(hair, q);
        girth.tuft = select(isLaced, girth.tuft, coil.tuft);
        girth.pathM = select(isLaced, girth.pathM, coil.pathM);
        girth.wispM = select(isLaced, girth.wispM, coil.wispM);
        twist = select(isLaced, twist, Num(kCoilTwist));
    }
    Num turned = hair.turns * q * kFullTurn;
    WispPath path = wispPath(lacing, turned + wisp / lacing.wisps * kFullTurn);
    Num perLength = girth.pathM * hair.turns * kFullTurn / most(braidM, Num(1e-6F));
    Num onwardX = path.onwardX * perLength;
    Num onwardZ = path.onwardZ * perLength;
    Num perUnit = 1.0F / root(1.0F + onwardX * onwardX + onwardZ * onwardZ);
    Vec3 along = vec3Of(onwardX * perUnit, perUnit, onwardZ * perUnit);
    // A hair's position in the wisp lies across the wisp's own path, so that wisps are round, and turns about it.
    Num aside = root(along.y * along.y + along.z * along.z);
    Num c = cosOf(turned * twist);
    Num s = sinOf(turned * twist);
    Num x = (hair.wispX * c - hair.wispY * s) * girth.wispM;
    Num y = (hair.wispX * s + hair.wispY * c) * girth.wispM;
    // Along the braid they have the room that their number leaves.
    Num roomM = braidM * lacing.roomTurns / most(hair.turns, Num(1e-3F));
    Num squash = least(Num(1.0F), roomM / most(girth.wispM, Num(1e-6F)));
    Num shorter = braidM * (kTuftFraction * kTuftUneven) * girth.tuft * partOf(hair.chance * kOwnEndFactor + 0.5F);
    Vec3 laced = vec3Of(path.x * girth.pathM + x * aside,
                        0.0F - (x * along.x * along.y + y * along.z) / aside * squash - shorter,
                        path.z * girth.pathM + (y * along.y - x * along.x * along.z) / aside);
    if (everywhere(isLaced))
        return laced;
    // A coil's rope lies across the axis nearly everywhere: outward and along the axis are across the rope.
    // Its end is tucked in.
    Num tuckedM = girth.tuft * girth.wispM * kCoilTucked;
    return select(isLaced, laced, vec3Of(path.x * (girth.pathM + x), y - tuckedM, path.z * (girth.pathM + x)));
}

// Frizz: noise along the strand that is 0 at the root and grows to the tip.
struct Frizz
{
    Num radiusM; // Greatest distance from the strand's course, at the tip.
    Num waveRad; // Phase of the wave over the whole strand.
};

CURVE_FUNCTION Frizz frizzOf(Num frizzM, Num lengthM)
{
    Frizz frizz;
    frizz.radiusM = least(frizzM, lengthM * kMostFrizzFraction);
    frizz.waveRad = lengthM * 6.28318531F / (frizz.radiusM * kFrizzWaveRadii + kFrizzWaveM);
    return frizz;
}

// Offset from the strand's course at fraction s, m: along the frame's first axis and across it. `chance` is the hair's
// own, -1..1.
CURVE_FUNCTION Vec3 frizzOffset(Frizz frizz, Num chance, Num s)
{
    Num angle = frizz.waveRad * s + chance * 47.0F;
    Num x = sinOf(angle) * (1.0F - kFrizzFinePart) + sinOf(angle * kFrizzFiner + chance * 29.0F) * kFrizzFinePart;
    Num other = frizz.waveRad * s * 1.13F - chance * 71.0F;
    Num y = cosOf(other) * (1.0F - kFrizzFinePart) + cosOf(other * kFrizzFiner + chance * 17.0F) * kFrizzFinePart;
    Num reachM = frizz.radiusM * s * 0.70710678F;
    return vec3Of(x * reachM, y * reachM, 0.0F);
}
