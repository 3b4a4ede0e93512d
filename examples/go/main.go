// Command decoder is a decoder of pseudorandom arrays that speaks the conformance protocol: JSON
// lines on standard input and output, or one request with --one-shot.
package main

import (
	"bufio"
	"bytes"
	"encoding/json"
	"fmt"
	"os"
	"sort"
)

const (
	inFlight = 64
	longest  = 1 << 20
)

var names = func() []string {
	names := []string{}
	for name := range operations {
		names = append(names, name)
	}
	sort.Strings(names)
	return names
}()

// parsed reads a request; numbers keep their text, so that 2.0 is told from 2.
func parsed(line []byte) (object, error) {
	decoder := json.NewDecoder(bytes.NewReader(line))
	decoder.UseNumber()
	var request object
	err := decoder.Decode(&request)
	if err == nil && request == nil {
		err = fmt.Errorf("null")
	}
	return request, err
}

// answered is the reply to what may refuse, or stop reading what is invalid.
func answered(compute func() (any, error)) (reply object) {
	defer func() {
		if stopped := recover(); stopped == invalid {
			reply = object{"refused": string(invalid)}
		} else if stopped != nil {
			panic(stopped)
		}
	}()
	result, err := compute()
	if err != nil {
		return object{"refused": err.Error()}
	}
	return object{"result": result}
}

func open(request object) (a *Array, reply object) {
	reply = answered(func() (any, error) {
		opened, err := NewArray(profile(request["profile"]))
		a = opened
		return true, err
	})
	return a, reply
}

func run(a *Array, request object) object {
	name, _ := request["operation"].(string)
	operation, known := operations[name]
	switch {
	case a == nil:
		return object{"errored": "no profile is in force"}
	case !known:
		return object{"skipped": "no such operation", "link": "docs/reference/protocol.md"}
	}
	return answered(func() (any, error) { return operation(a, request["input"]) })
}

// numbered repeats the sequence of the request, if it has one.
func numbered(request, reply object) object {
	if sequence, given := request["sequence"]; given {
		reply["sequence"] = sequence
	}
	return reply
}

func oneShot(request object) object {
	a, reply := open(request)
	if _, asked := request["operation"]; asked && a != nil {
		reply = run(a, request)
	}
	return numbered(request, reply)
}

// converse answers line after line, and writes when no further line is at hand.
func converse(in *bufio.Reader, out *bufio.Writer) {
	var inForce *Array
	encoder := json.NewEncoder(out)
	for {
		line, err := in.ReadBytes('\n')
		if err != nil {
			return
		}
		request, err := parsed(line)
		var reply object
		switch command := request["command"]; {
		case err != nil:
			reply = object{"errored": "not a request: " + err.Error()}
		case command == "start":
			reply = object{"protocol": 1, "name": "go-example", "operations": names,
				"in_flight": inFlight}
		case command == "profile":
			inForce, reply = open(request)
		case command == "run":
			reply = numbered(request, run(inForce, request))
		case command == "stop":
			return
		default:
			reply = object{"errored": "no such command"}
		}
		encoder.Encode(reply)
		if in.Buffered() == 0 {
			out.Flush()
		}
	}
}

func main() {
	in, out := bufio.NewReaderSize(os.Stdin, longest), bufio.NewWriter(os.Stdout)
	defer out.Flush()
	switch {
	case len(os.Args) == 1:
		converse(in, out)
	case len(os.Args) == 2 && os.Args[1] == "--one-shot":
		line, _ := in.ReadBytes('\n')
		request, err := parsed(line)
		reply := object{"errored": "not a request"}
		if err == nil {
			reply = oneShot(request)
		}
		json.NewEncoder(out).Encode(reply)
	default:
		fmt.Fprintln(os.Stderr, "usage: decoder [--one-shot]")
		os.Exit(2)
	}
}
