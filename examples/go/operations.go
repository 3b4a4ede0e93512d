package main

import "math/big"

// The operations: of an array and an input to a result.
var operations = map[string]func(a *Array, input any) (any, error){
	"add": func(a *Array, in any) (any, error) {
		x, y := a.code(take(in, "a")), a.code(take(in, "b"))
		return a.field.add(x, y), nil
	},
	"multiply": func(a *Array, in any) (any, error) {
		x, y := a.code(take(in, "a")), a.code(take(in, "b"))
		return a.field.multiply(x, y), nil
	},
	"negate": func(a *Array, in any) (any, error) {
		return a.field.negatives[a.code(take(in, "a"))], nil
	},
	"inverse": func(a *Array, in any) (any, error) {
		return a.powerOf(a.code(take(in, "a")), big.NewInt(-1))
	},
	"power": func(a *Array, in any) (any, error) {
		return a.powerOf(a.code(take(in, "a")), integer(take(in, "exponent")))
	},
	"trace": func(a *Array, in any) (any, error) {
		return a.field.trace(a.code(take(in, "a"))), nil
	},
	"logarithm": func(a *Array, in any) (any, error) {
		x := a.code(take(in, "a"))
		if x == 0 {
			return nil, refusal("out-of-range")
		}
		return a.field.log[x], nil
	},
	"primitive": func(a *Array, in any) (any, error) {
		return a.field.isPrimitive(a.codes(take(in, "polynomial"))), nil
	},
	"first-primitive": func(a *Array, in any) (any, error) {
		degree := small(take(in, "degree"), 1<<20)
		demand(degree > 0)
		return a.field.firstPrimitive(degree), nil
	},
	"term": func(a *Array, in any) (any, error) {
		return a.terms[modulo(natural(take(in, "index")), a.size)], nil
	},
	"terms": func(a *Array, in any) (any, error) {
		from, length := natural(take(in, "from")), small(take(in, "length"), 200000)
		terms := make([]int, length)
		for k := range terms {
			terms[k] = a.terms[(modulo(from, a.size)+k)%a.size]
		}
		return terms, nil
	},
	"cell": func(a *Array, in any) (any, error) {
		row, column := natural(take(in, "row")), natural(take(in, "column"))
		return a.terms[a.index(modulo(row, a.size), modulo(column, a.size))], nil
	},
	"pack":   pack,
	"unpack": unpack,
	"locate": func(a *Array, in any) (any, error) {
		return placed(a.locate(a.patch(take(in, "patch"), a.certain)))
	},
	"nearest": func(a *Array, in any) (any, error) {
		patch, radius := a.patch(take(in, "patch"), a.certain), -1
		if stated := take(in, "radius"); stated != nil {
			radius = small(stated, 1<<30)
		}
		return placed(a.nearest(patch, radius))
	},
	"posterior": func(a *Array, in any) (any, error) {
		return a.posterior(a.patch(take(in, "patch"), a.chances))
	},
	"prove": func(a *Array, in any) (any, error) {
		proof, any := a.prove(mask(take(in, "mask")))
		if !any {
			return nil, refusal("off-sheet")
		}
		return proof, nil
	},
	"distance": func(a *Array, in any) (any, error) {
		return a.distance(mask(take(in, "mask"))), nil
	},
}

func (a *Array) powerOf(x int, exponent *big.Int) (any, error) {
	switch {
	case x != 0:
		return a.field.power(x, exponent), nil
	case exponent.Sign() < 0:
		return nil, refusal("division-by-zero")
	case exponent.Sign() == 0:
		return 1, nil
	}
	return 0, nil
}

// ordered has the most significant cell first, or undoes that.
func (a *Array) ordered(cells []int) []int {
	if a.leastFirst {
		for i, j := 0, len(cells)-1; i < j; i, j = i+1, j-1 {
			cells[i], cells[j] = cells[j], cells[i]
		}
	}
	return cells
}

func pack(a *Array, in any) (any, error) {
	cells := a.codes(take(in, "cells"))
	demand(len(cells) == a.k1*a.k2)
	packed := new(big.Int)
	for _, c := range a.ordered(cells) {
		packed.Mul(packed, big.NewInt(int64(a.q))).Add(packed, big.NewInt(int64(c)))
	}
	if packed.BitLen() > 53 { // above 2^53 - 1
		return packed.String(), nil
	}
	return packed.Int64(), nil
}

func unpack(a *Array, in any) (any, error) {
	packed, q, digit := natural(take(in, "packed")), big.NewInt(int64(a.q)), new(big.Int)
	cells := make([]int, a.k1*a.k2)
	for k := len(cells) - 1; k >= 0; k-- {
		packed.DivMod(packed, q, digit)
		cells[k] = int(digit.Int64())
	}
	if packed.Sign() > 0 {
		return nil, refusal("out-of-range")
	}
	return a.ordered(cells), nil
}

func placed(found []Offset, err error) (any, error) {
	positions := []object{}
	for _, at := range found {
		positions = append(positions, object{"row": at.row, "column": at.column})
	}
	if len(positions) == 1 {
		return object{"position": positions[0]}, err
	}
	return object{"positions": positions}, err
}
