{-# OPTIONS_HADDOCK hide #-}

-- | The law of order: earlier questions, answered or refused, do not change an answer. Questions
-- are asked in a drawn order, and each must have its own right answer.
module PraTactile.Conformance.Laws.Order
  ( orderLaw,
    orderName,
  )
where

import PraTactile.Conformance.Definition (ProfileFacts)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Operations.Conventions (lessList)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf)
import Test.QuickCheck (choose, elements, oneof, vectorOf)

-- | The law that these operations are answered alike in any order. The last operation belongs to
-- the stage.
orderLaw :: Stage -> [SomeOp] -> Law ProfileFacts
orderLaw stage operations =
  law
    stage
    orderName
    operations
    "an answer does not depend on what was asked before, nor on whether that was refused"
    "the protocol: each request is answered by itself"
    $ \known ->
      let one = oneof [elements (askedOf operation) | operation <- operations]
          askedOf operation = refusedOf known operation ++ typicalOf known operation
       in Cases
            (listOf questionForm)
            ( Some
                (choose (2, 5) >>= (`vectorOf` one))
                (filter (not . null) . lessList smallerQuestions)
            )
            (inOrder known)

-- | The name of this law in each stage. An answer that is also wrong in a fresh process does not
-- violate it, because there nothing was asked before.
orderName :: String
orderName = "in-any-order"
