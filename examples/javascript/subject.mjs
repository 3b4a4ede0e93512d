// The conformance protocol: a session of lines, or with --one-shot a single request.
import { readFileSync } from "node:fs";
import { arrayOf } from "./array.mjs";
import { operations } from "./operations.mjs";
import { isObject, parse, print, profile, refuse, reply } from "./reading.mjs";

function run(array, request) {
  const repeated = request.sequence === undefined ? {} : { sequence: request.sequence };
  if (!Object.hasOwn(operations, request.operation)) return { ...repeated, skipped: "no such operation" };
  return {
    ...repeated,
    ...reply(() => operations[request.operation](array, isObject(request.input) ? request.input : refuse("invalid"))),
  };
}

let inForce;

function answer(request) {
  switch (request.command) {
    case "start":
      return { protocol: 1, name: "pra-tactile in JavaScript", operations: Object.keys(operations), in_flight: 64 };
    case "profile":
      inForce = undefined;
      return reply(() => ((inForce = arrayOf(profile(request.profile))), true));
    case "run":
      return inForce ? run(inForce, request) : { sequence: request.sequence, errored: "no profile is in force" };
    default:
      return { errored: "no such command" };
  }
}

function once(request) {
  let array;
  const possible = reply(() => ((array = arrayOf(profile(request.profile))), true));
  if (array && request.operation !== undefined) return run(array, request);
  return request.sequence === undefined ? possible : { sequence: request.sequence, ...possible };
}

if (process.argv.includes("--one-shot")) {
  console.log(print(once(parse(readFileSync(0, "utf8")))));
} else {
  let rest = "";
  process.stdin.setEncoding("utf8");
  process.stdin.on("data", (text) => {
    const lines = (rest + text).split("\n");
    rest = lines.pop();
    for (const line of lines) {
      const said = reply(() => {
        const request = parse(line);
        return request.command === "stop" ? undefined : answer(request);
      });
      // What was written before may still be on its way, so that the process is not ended at once.
      if ("result" in said && said.result === undefined) return process.stdin.destroy();
      process.stdout.write(`${print(said.result ?? said)}\n`);
    }
  });
}
