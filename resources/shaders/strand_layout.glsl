// How strands lie in the GPU's buffers (std430). Read as GLSL by every shader, and as C++ by packed_style.h.

// Skeletons: [slots / kStrandLanes][nodes][3][kStrandLanes] floats.
const uint kStrandLanes = 16u;
const uint kTautBit = 0x8000u;

// A strand that is drawn, and where its points begin.
struct DrawnStrand
{
    uint slot;       // In the order of the frame's positions.
    uint firstPoint; // The strand has a point more than segments.
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
    float order;    // 0..1: where not all hairs are drawn, those of the lowest order are.
    float lengthM;
    float frizzM;
    float shine;     // Its gloss's factor on the group's shine.
    float sharpness; // Its gloss's factor on the sharpness of highlights.
    float tipStart; // 0..1 of the rest of its length beyond where the group's tip colours begin.
    uint tangentHd; // A unit vector in an octahedron's two coordinates, as unpackSnorm2x16 reads them.
};
