// The conformance protocol: a session of lines, or with --one-shot a single request.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { arrayOf } from "./array.mjs";
import { operations } from "./operations.mjs";
import { object, parse, print, profile, reply } from "./reading.mjs";

let inForce;

function open(request) {
  inForce = undefined;
  return reply(() => Boolean((inForce = arrayOf(profile(request.profile)))));
}

function run({ operation, input }) {
  if (!inForce) return { errored: "no profile is in force" };
  if (!Object.hasOwn(operations, operation)) return { skipped: "no such operation" };
  return reply(() => operations[operation](inForce, object(input)));
}

function answer(request) {
  const name = "pra-tactile in JavaScript";
  switch (request.command) {
    case "start":
      return { protocol: 1, name, operations: Object.keys(operations), in_flight: 64 };
    case "profile":
      return open(request);
    case "run":
      return { sequence: request.sequence, ...run(request) };
    default:
      return { errored: "no such command" };
  }
}

function once(request) {
  const opened = open(request);
  const isAsked = inForce && request.operation !== undefined;
  return { sequence: request.sequence, ...(isAsked ? run(request) : opened) };
}

if (process.argv.includes("--one-shot")) {
  console.log(print(once(parse(readFileSync(0, "utf8")))));
} else {
  const lines = createInterface({ input: process.stdin });
  lines.on("line", (line) => {
    const { result: request, ...fault } = reply(() => parse(line));
    if (request?.command === "stop") process.stdin.destroy();
    else console.log(print(request ? answer(request) : fault));
  });
}
