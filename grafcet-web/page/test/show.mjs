// Shows a folder on this machine: `node show.mjs FOLDER`.

import { serve } from "./browser.mjs";

const { address } = await serve(process.argv[2]);
console.log(`${address} until Ctrl-C`);
