<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es">
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste into %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>%1. Usage: hairpaint %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file name belongs here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exactly one project is wanted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--%1 takes a number from %2 to %3, not &apos;%4&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>-o takes a name that ends in .hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Head: %1, %2 vertices, %3 triangles
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hairs: %1 (%2 exported, %3 basis hairs), seed %4
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group %1: %2 hairs of %3 nodes
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>  %1: %2 x %3, layers: %4
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hairpaint [PROJECT]  opens the editor
</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Add group &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove group &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename group &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show group &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide group &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply style &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add layer to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove layer &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layer &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change head</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>its archive is cut short or broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not a file of Hair Paint; choose another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds more than %1 entries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of its entries has an unacceptable name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds two entries named &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is packed in an unacceptable way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its entry &apos;%1&apos; is broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its archive could not be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its head&apos;s mesh is broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no hair group, or too many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its map &apos;%1&apos; is not known to this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its list of groups, maps and layers is broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has too many groups or layers; remove some</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the hair has too many points for this format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its head is %1 m large, and heads of 1 mm to 100 m can be used; choose another unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its mesh has no surface; choose another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image holds no pixels; choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the helper program hairpaint-import could not be started; install Hair Paint again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading it failed, so it is likely damaged; convert it with another program and try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it took too long; try a smaller or simpler file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the helper program&apos;s answer made no sense; convert the file with another program and try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it could not be read; check that it is there and may be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its format is not known; convert it to PNG (an image) or glTF (a mesh)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is damaged or cut short; try another copy of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is too large; try one of at most 8192 x 8192 pixels or 2 million vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no surface; choose a mesh of triangles or polygons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its mesh has no uv coordinates, which the maps need; unwrap it in a 3D program first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>images with this ending can&apos;t be written; use .png, .tif or .exr</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there was not enough memory for it; try a smaller one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; in project.json is not what it should be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its maps are larger than this program can hold; use fewer layers or smaller maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a file of another kind (%1); choose another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is not enough memory to encode its maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its format version is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its format is %1, and this Hair Paint reads up to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of its images is broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of its images is not a PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of its images is not %1 x %1 in 16-bit RGBA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its head &apos;%1&apos; is not known to this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its project.json is too large or nested too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its project.json can&apos;t be understood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its way of drawing roots is not known to this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be opened: %2; open it with a newer Hair Paint.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be opened: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; is damaged: %2; try an earlier copy of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; can&apos;t be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Working on &apos;%1&apos; was cancelled; nothing has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such file; check the name and the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a folder; choose a file inside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is not an ordinary file; choose another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is empty; choose another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is larger than %1, the most that is read; choose a smaller file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; check that you may read it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HairColours</name>
    <message>
        <source>1 Black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 Darkest brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3 Dark brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4 Medium brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 Light brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6 Dark blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>7 Medium blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8 Light blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>9 Very light blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 Lightest blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mahogany</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auburn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chestnut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ginger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strawberry blonde</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steel grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Salt and pepper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burgundy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cherry red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lilac</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Violet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Midnight blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HairSettings</name>
    <message>
        <source>Greatest length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length where the length map is brightest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length where the length map is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hairs where the density map is brightest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hairs/cm²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of one hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curl radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest radius of a curl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nodes per hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More bend more finely and cost more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Basis hairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hairs that are simulated; the others follow them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between braids in one painted patch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of a braid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How firmly hair keeps its shape near the root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far long hair is combed to either side of the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweep back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far long hair is combed away from the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How soon motion dies down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>per s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 % is as on earth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much hair sticks to the head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the whole coat of hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How strongly the wind takes this hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the highlights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity at the root</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less lets the skin show through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity at the tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less makes hair thin out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour variation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference between neighbouring hairs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HeadImportDialog</name>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metres</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>HeadView</name>
    <message>
        <source>The window has no OpenGL context.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The OpenGL driver refuses to draw.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Landmarks</name>
    <message>
        <source>crown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hairline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chin</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Library</name>
    <message>
        <source>There is no style named &apos;%1&apos;; &apos;hairpaint presets&apos; lists those there are.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MapSpec</name>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Braid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>No picture can be drawn: %1 Install a driver with OpenGL 4.3 (Debian: libgl1-mesa-dri).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Pointer</name>
    <message>
        <source>Size %1 cm, hardness %2 %, opacity %3 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>Layer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scalp</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Tool</name>
    <message>
        <source>Eraser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to erase; Shift+click for a straight line from the last point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to paint; Shift+click for a straight line from the last point; Ctrl+click picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to fill what has a similar value around the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag from the first value to the second; Shift keeps to steps of 45 degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to take the value under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a rectangle, Shift for a square; click to select nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click corner by corner; click the first one to close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a filled shape; Shift makes it a square or a circle; polygons: click corner by corner</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>hairs/cm²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns per %1 cm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::app::Exchange</name>
    <message>
        <source>Load image into %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.tga *.bmp *.webp *.psd)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load %1 into %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save %1 as image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images (*.png *.tif *.exr *.tga)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes (*.glb *.gltf *.obj *.fbx *.ply *.dae *.3ds *.x3d)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair curves (*.hair)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no OpenGL on this machine to draw a picture with; install a graphics driver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hairstyle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; could not be written: %2. Choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; could not be made; check that you may write there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a style &apos;%1&apos; already. Replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Style &apos;%1&apos; saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &apos;%1&apos; to the trash?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; could not be moved to the trash; delete it by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>;;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::app::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load &amp;image into map ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;map as image ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import &amp;head ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the &amp;built-in head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export hair ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mirror painting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;ferences ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer &amp;up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer &amp;down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;wap values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Both areas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;3D area only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paint area only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Swap sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide panels	Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mirror the paint area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Night paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;hree-quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W&amp;ind ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weat&amp;her keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add hair group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remo&amp;ve hair group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save style ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Hair Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was copied yet: select a part of a map and copy it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::app::ProjectFiles</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair Paint projects (*.hairpaint)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save changes?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changes that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::AboutDialog</name>
    <message>
        <source>About Hair Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program&apos;s picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint maps over a head and watch the hair grow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After “Hair Paint” by B. Hernandez and I. Rudomin, 2004. Free software under the MIT licence: use it, change it, pass it on. It comes without any warranty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Qt %1 on %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::BarSlider</name>
    <message>
        <source>Ctrl-drag for fine, double-click to type, right-click to reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl-drag for fine, double-click to type</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::DirectionBall</name>
    <message>
        <source>Where the light comes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the wind blows to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn; double-click for the other half (front or back); arrows for small steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1° around, %2° up</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::EditorState</name>
    <message>
        <source>There is no hair group to paint on; add one in the Maps panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This map has no layer to paint on; add one in the Layers panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is hidden; show the group to paint on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is hidden; show the layer to paint on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is locked; unlock the layer to paint on it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HairPanel</name>
    <message>
        <source>Hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add hair group</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove hair group (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Braids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the turns of a curl are counted by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns per hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns per length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns are for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole curl levels only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curl levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of &quot;%2&quot;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HeadImportDialog</name>
    <message>
        <source>“%1” holds no triangles. Export the head as a mesh and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has no UV layout, and without one there is nothing to paint on. Unwrap the head in your 3D program and export it with its UVs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y (glTF, Maya)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z (Blender, 3ds Max)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One &amp;unit is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Up is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 triangles. %2 cm is no usual height for a head, a bust or a body: check the unit and the axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 triangles, %2 cm tall.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::HeadView</name>
    <message>
        <source>The hair can&apos;t be shown here: %1 Painting, saving and exporting work all the same.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::LayersPanel</name>
    <message>
        <source>Multiply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the layer mixes with those below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers, topmost first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layer up (Alt+Up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layer down (Alt+Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove layer (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lock layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer blend mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, hidden</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layer &quot;%1&quot;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::LightDialog</name>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comes from, around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comes from, above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapRow</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MapsPanel</name>
    <message>
        <source>Maps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::MeshSilhouette</name>
    <message>
        <source>The mesh from the front</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::OptionBar</name>
    <message>
        <source>Tool options</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the value from the palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen pressure changes the size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen pressure changes the opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radial gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palette, %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::PaintView</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Graphics card (OpenGL)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a picture (software)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White &amp;paper under the maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D &amp;area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic takes the graphics card where there is one. A change takes effect at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps go from white to their colour instead of from black. Exported images always do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search by name or key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New key of the chosen action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an action, then press its new key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has this key now and will lose it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the new key in the field, then Assign.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::Section</name>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folded</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::Sidebar</name>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StatusReadout</name>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 hairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of one step of the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 hairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleStrip</name>
    <message>
        <source>Styles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save style</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this hair as a style of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Point to see it, click to keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete style</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::StyleTile</name>
    <message>
        <source>Loading…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ToolBar</name>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ValuePair</name>
    <message>
        <source>Value and second value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paints %1; the second value is %2. Click to swap (X)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::ValuePalette</name>
    <message>
        <source>Swap the two values (X)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the two values (D)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair colour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::WeatherOverlay</name>
    <message>
        <source>Weather</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wind %1 m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wind is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R  G  B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more red, green, blue light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+R  G  B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leaves</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hairpaint::view::WindDialog</name>
    <message>
        <source>Wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind &amp;blows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blows to, around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0° blows toward the viewer in front, 90° to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blows to, upward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the strength that comes and goes over seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the strength that differs from place to place</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
