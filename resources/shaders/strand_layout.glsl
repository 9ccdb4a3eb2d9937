// How strands lie in the GPU's buffers (std430). Read as GLSL by every shader, and as C++ by packed_style.h.

// Skeletons: [slots / kStrandLanes][nodes][3][kStrandLanes] floats.
const uint kStrandLanes = 16u;
const uint kTautBit = 0x8000u;

// A strand that is drawn, and where its points begin.
struct DrawnStrand
{
    uint slot;       // In the order of the frame's positions.
    uint firstPoint; // Of segments + 1.
};

// What a strand looks like: sim::StrandStyle, with its root's tangent.
struct PackedStyle
{
    float turns;
    float curlRadiusM;
    float phase;
    uint rootColour;
    uint tipColour;
    float width;
    uint braid; // sim::BraidKind; bits 8 to 11 the wisp; kTautBit: see sim::StrandStyle::isTaut(); 16 to 23 braidTaper,
                // 24 to 31 braidTied.
    float braidRadiusM;
    float braidStart;
    float braidTurns;
    float wispOffsetX;
    float wispOffsetY;
    float variation;
    float order;    // 0..1: hairs of a low one stand for the others where not all are drawn.
    float lengthM;
    float frizzM;
    float shine;     // Of the group's, as its gloss has it,
    float sharpness; // and of how sharp the highlights are.
    float tipStart; // 0..1 of the rest of its length beyond where the group's tip colours begin.
    uint tangentHd; // A unit vector in an octahedron's two coordinates, as unpackSnorm2x16 reads them.
};
