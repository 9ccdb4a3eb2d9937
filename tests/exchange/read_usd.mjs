// Reads a USD file with tinyusdz and prints, as JSON, whether it could and what it has read, as text again:
// node read_usd.mjs FOLDER_OF_TINYUSDZ FILE
// The module is made for browsers and refuses to run where there is a process, so it is shown none.
import fs from "fs";

const [folder, path] = process.argv.slice(2);
const source = fs.readFileSync(`${folder}/tinyusdz.js`, "utf8")
    .replace(/export default \w+;?\s*$/, "")
    .replace(/import\.meta\.url/g, '"file:///tinyusdz.js"');
const make = new Function("process", "window", "document", `${source}\nreturn Module;`)(undefined, {}, {});
const usd = await make({ wasmBinary: fs.readFileSync(`${folder}/tinyusdz.wasm`) });
const loader = new usd.TinyUSDZLoaderNative();
const bytes = new Uint8Array(fs.readFileSync(path));
const ok = loader.loadFromBinary(bytes, path);
const layer = new usd.TinyUSDZLoaderNative();
const text = path.endsWith(".usda") && layer.loadAsLayerFromBinary(bytes, path) ? layer.layerToString() : "";
console.log(JSON.stringify({ ok, error: loader.error(), text }));
