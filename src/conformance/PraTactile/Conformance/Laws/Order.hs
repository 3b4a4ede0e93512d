{-# OPTIONS_HADDOCK hide #-}

-- | What was asked before does not matter, answered or refused: questions in an order that is
-- drawn, each with the answer that it has alone.
module PraTactile.Conformance.Laws.Order
  ( orderLaw,
    orderName,
  )
where

import PraTactile.Conformance.Definition (Known)
import PraTactile.Conformance.Law
import PraTactile.Conformance.Laws.Judge
import PraTactile.Conformance.Operations
import PraTactile.Conformance.Operations.Conventions (lessList)
import PraTactile.Conformance.Question
import PraTactile.Format.Json.Codec (listOf)
import Test.QuickCheck (choose, elements, oneof, vectorOf)

-- | That these operations, the last of which is of the stage, are answered alike in any order.
orderLaw :: Stage -> [SomeOp] -> Law Known
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

-- | The name of the law in each stage. An answer that is wrong in a fresh process, too, does not
-- violate it: that process was asked nothing before.
orderName :: String
orderName = "in-any-order"
