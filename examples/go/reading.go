package main

import (
	"encoding/json"
	"math"
	"math/big"
	"strings"
)

// A refusal is the reason why there is no answer.
type refusal string

func (r refusal) Error() string { return string(r) }

const invalid = refusal("invalid")

type object = map[string]any

// demand stops the reading of a request that is not as it must be.
func demand(condition bool) {
	if !condition {
		panic(invalid)
	}
}

func take(given any, key string) any {
	fields, ok := given.(object)
	demand(ok)
	value, ok := fields[key]
	demand(ok)
	return value
}

// integer reads a whole number, plainly or as a decimal string; 2.0 and 2e0 are none.
func integer(value any) *big.Int {
	text := ""
	switch v := value.(type) {
	case json.Number:
		text = v.String()
	case string:
		text = v
	}
	digits := strings.TrimPrefix(text, "-")
	demand(digits != "" && len(digits) <= 4096 && strings.Trim(digits, "0123456789") == "")
	n, _ := new(big.Int).SetString(text, 10)
	return n
}

func natural(value any) *big.Int {
	n := integer(value)
	demand(n.Sign() >= 0)
	return n
}

// small is a natural number, or the limit where it is that or more.
func small(value any, limit int) int {
	n := natural(value)
	if n.Cmp(big.NewInt(int64(limit))) >= 0 {
		return limit
	}
	return int(n.Int64())
}

func modulo(n *big.Int, size int) int {
	return int(new(big.Int).Mod(n, big.NewInt(int64(size))).Int64())
}

func many(value any) []any {
	list, ok := value.([]any)
	demand(ok)
	return list
}

func (a *Array) code(value any) int {
	c := small(value, 256)
	demand(c < a.q)
	return c
}

func (a *Array) codes(value any) []int {
	codes := []int{}
	for _, item := range many(value) {
		codes = append(codes, a.code(item))
	}
	return codes
}

// patch reads the observed cells; null is a cell that was not observed.
func (a *Array) patch(value any, read func(any) Felt) []Felt {
	rows := many(value)
	demand(len(rows) > 0 && len(many(rows[0])) > 0)
	patch := []Felt{}
	for i, row := range rows {
		demand(len(many(row)) == len(many(rows[0])))
		for j, cell := range many(row) {
			if cell != nil {
				felt := read(cell)
				felt.at = Offset{i, j}
				patch = append(patch, felt)
			}
		}
	}
	return patch
}

func (a *Array) certain(value any) Felt { return Felt{code: a.code(value)} }

// chances reads the probability of each code: a code is certain, a list is divided by its sum.
func (a *Array) chances(value any) Felt {
	chances := make([]float64, a.q)
	list, ok := value.([]any)
	if !ok {
		chances[a.code(value)] = 1
		return Felt{chances: chances}
	}
	demand(len(list) == a.q)
	total := 0.0
	for k, item := range list {
		number, ok := item.(json.Number)
		demand(ok)
		chance, err := number.Float64()
		demand(err == nil && chance >= 0)
		chances[k] = chance
		total += chance
	}
	demand(math.Abs(total-1) <= 0.001+1e-12)
	for k := range chances {
		chances[k] /= total
	}
	return Felt{chances: chances}
}

// mask reads the offsets that a drawing such as ##./.## marks.
func mask(value any) []Offset {
	drawing, ok := value.(string)
	demand(ok && strings.Trim(drawing, "#./") == "")
	rows := strings.Split(drawing, "/")
	offsets := []Offset{}
	for i, row := range rows {
		demand(len(row) == len(rows[0]))
		for j, c := range row {
			if c == '#' {
				offsets = append(offsets, Offset{i, j})
			}
		}
	}
	demand(len(offsets) >= 1 && len(offsets) <= 4096)
	return offsets
}

// profile reads a profile; what is vast in it is taken for 2^30, which no array here has.
func profile(given any) Profile {
	number := func(value any) int { return small(value, 1<<30) }
	numbers := func(key string) []int {
		list := []int{}
		for _, item := range many(take(given, key)) {
			list = append(list, number(item))
		}
		return list
	}
	pair := func(key string) (int, int) {
		list := numbers(key)
		demand(len(list) == 2)
		return list[0], list[1]
	}
	among := func(key string, names ...string) string {
		for _, name := range names {
			if take(given, key) == name {
				return name
			}
		}
		panic(invalid)
	}
	among("schema", "pra-tactile/profile/1")
	p := Profile{
		q:          number(take(given, "q")),
		modulus:    numbers("modulus"),
		polynomial: numbers("polynomial"),
		state:      numbers("state"),
		reciprocal: among("reading", "characteristic", "reciprocal") == "reciprocal",
		rowMajor:   among("folding", "diagonal", "row-major") == "row-major",
		surface:    among("surface", torus, twistedTorus, sheet),
		leastFirst: among("packing", "most-significant-first", "least-significant-first") ==
			"least-significant-first",
	}
	p.n1, p.n2 = pair("shape")
	p.k1, p.k2 = pair("window")
	return p
}
