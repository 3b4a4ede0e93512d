-- | What impostors say of the inputs that they read.
module Test.Conformance.Sentences.Reading (spec, names) where

import Control.Monad (unless)
import Control.Monad.Trans.Except (runExceptT)
import Data.Aeson (Value, decode)
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.Foldable (for_)
import Data.List (find)
import PraTactile.Conformance
import PraTactile.Conformance.Impostors
import PraTactile.Conformance.Question
import Test.Conformance.Sentences.Said
import Test.Hspec

-- | What is read of inputs that are none, as if others were given.
spec :: Spec
spec = describe "of reading inputs" $
  for_ readings $ \(name, cases) -> it name $ do
    one <- maybe (fail ("no impostor " ++ name)) pure (find ((== name) . impostorName) impostors)
    for_ (profilesNamed ["paper", "gf3-2x13"]) $ \p -> do
      about <- either (fail . show) pure (known p)
      session <- runExceptT (open (impostorMake one library) p) >>= either (fail . show) pure
      for_ cases $ \(operation, given, asIf) -> do
        [input, other] <- pure (concatMap values [given, asIf])
        came <- runExceptT (answerOf session (Raw operation input))
        let said = right about (Raw operation other)
        unless (alike about (Raw operation other) said came) $
          (operation, given, came) `shouldBe` (operation, given, said)
  where
    values text = maybe [] pure (decode (Lazy.pack text)) :: [Value]

-- | The impostors of which something is said here.
names :: [String]
names = map fst readings

-- | An input of an operation, and as which one it is taken.
readings :: [(String, [(Operation, String, String)])]
readings =
  [ ( "takes-anything-for-a-number",
      [ (OfAdd, "{\"a\": true, \"b\": false}", "{\"a\": 1, \"b\": 0}"),
        (OfAdd, "{\"a\": 2.9, \"b\": {\"c\": 2}}", "{\"a\": 2, \"b\": 0}"),
        (OfAdd, "{\"a\": -0.5, \"b\": \"1\"}", "{\"a\": 0, \"b\": \"1\"}"),
        (OfAdd, "{\"a\": -1.5, \"b\": 1}", "{\"a\": -1, \"b\": 1}"),
        (OfAdd, "{\"a\": null, \"b\": 1}", "{\"a\": null, \"b\": 1}"),
        (OfAdd, "[1, true]", "[1, true]"),
        (OfPower, "{\"a\": true, \"exponent\": -2.5}", "{\"a\": 1, \"exponent\": -2}"),
        (OfPrimitive, "{\"polynomial\": [true, {}, 1.5, 1]}", "{\"polynomial\": [1, 0, 1, 1]}"),
        ( OfLocate,
          "{\"patch\": [[true, {}, null], [1.5, 0, 1]]}",
          "{\"patch\": [[1, 0, null], [1, 0, 1]]}"
        )
      ]
    ),
    ( "forgets-signs",
      [ (OfAdd, "{\"a\": -1, \"b\": 2}", "{\"a\": 1, \"b\": 2}"),
        (OfAdd, "{\"a\": -1, \"b\": -2}", "{\"a\": 1, \"b\": 2}"),
        (OfAdd, "{\"a\": 0, \"b\": -9}", "{\"a\": 0, \"b\": 9}"),
        (OfPower, "{\"a\": -2, \"exponent\": -1}", "{\"a\": 2, \"exponent\": -1}"),
        (OfPrimitive, "{\"polynomial\": [-1, 0, -1, 1]}", "{\"polynomial\": [1, 0, 1, 1]}"),
        (OfFirstPrimitive, "{\"degree\": -2}", "{\"degree\": 2}"),
        ( OfNearest,
          "{\"patch\": [[-1, null, 0]], \"radius\": -1}",
          "{\"patch\": [[1, null, 0]], \"radius\": 1}"
        ),
        (OfTerm, "{\"index\": \"-3\"}", "{\"index\": \"-3\"}")
      ]
    ),
    ( "takes-missing-keys-for-zero",
      [ (OfAdd, "{}", "{\"a\": 0, \"b\": 0}"),
        (OfAdd, "{\"b\": 1}", "{\"a\": 0, \"b\": 1}"),
        (OfMultiply, "{\"a\": 1}", "{\"a\": 1, \"b\": 0}"),
        (OfNegate, "{}", "{\"a\": 0}"),
        (OfPower, "{\"a\": 2}", "{\"a\": 2, \"exponent\": 0}"),
        (OfPrimitive, "{}", "{\"polynomial\": [1]}"),
        (OfFirstPrimitive, "{}", "{\"degree\": 1}"),
        (OfTerm, "{}", "{\"index\": 0}"),
        (OfTerms, "{\"length\": 4}", "{\"from\": 0, \"length\": 4}"),
        (OfTerms, "{\"from\": 4}", "{\"from\": 4, \"length\": 0}"),
        (OfCell, "{\"row\": 1}", "{\"row\": 1, \"column\": 0}"),
        (OfCell, "{\"column\": 1}", "{\"row\": 0, \"column\": 1}"),
        (OfPack, "{}", "{\"cells\": [0]}"),
        (OfUnpack, "{}", "{\"packed\": 0}"),
        (OfLocate, "{}", "{\"patch\": [[0]]}"),
        (OfNearest, "{\"patch\": [[1, 0]]}", "{\"patch\": [[1, 0]], \"radius\": null}"),
        (OfNearest, "{\"radius\": 1}", "{\"patch\": [[0]], \"radius\": 1}"),
        (OfPosterior, "{}", "{\"patch\": [[0]]}"),
        (OfProve, "{}", "{\"mask\": \"#\"}"),
        (OfDistance, "{}", "{\"mask\": \"#\"}"),
        (OfAdd, "[]", "[]")
      ]
    ),
    ( "fills-up-rows",
      [ ( OfNearest,
          "{\"patch\": [[1], [1, 0, 1], [0, 1]], \"radius\": 0}",
          "{\"patch\": [[1, null, null], [1, 0, 1], [0, 1, null]], \"radius\": 0}"
        ),
        ( OfNearest,
          "{\"patch\": [[], []], \"radius\": 0}",
          "{\"patch\": [[null], [null]], \"radius\": 0}"
        ),
        (OfNearest, "{\"patch\": [], \"radius\": 0}", "{\"patch\": [], \"radius\": 0}"),
        ( OfNearest,
          "{\"patch\": [[1, 0], 1], \"radius\": 0}",
          "{\"patch\": [[1, 0], 1], \"radius\": 0}"
        ),
        ( OfLocate,
          "{\"patch\": [[1, 0, 1, 1], [0, 1]]}",
          "{\"patch\": [[1, 0, 1, 1], [0, 1, null, null]]}"
        ),
        (OfPosterior, "{\"patch\": [[1], [0, 1]]}", "{\"patch\": [[1, null], [0, 1]]}"),
        (OfProve, "{\"mask\": \"#/##\"}", "{\"mask\": \"#./##\"}"),
        (OfProve, "{\"mask\": \"###//#\"}", "{\"mask\": \"###/.../#..\"}"),
        (OfDistance, "{\"mask\": \"\"}", "{\"mask\": \"\"}"),
        (OfPack, "{\"cells\": [1]}", "{\"cells\": [1]}"),
        (OfAdd, "[1, 1]", "[1, 1]")
      ]
    ),
    ( "reads-any-mark",
      [ (OfProve, "{\"mask\": \"#x/ #\"}", "{\"mask\": \"#./.#\"}"),
        (OfProve, "{\"mask\": \"#\\u00e9#\"}", "{\"mask\": \"#.#\"}"),
        (OfProve, "{\"mask\": \"/##/\"}", "{\"mask\": \"##\"}"),
        (OfProve, "{\"mask\": \"##//#.\"}", "{\"mask\": \"##/#.\"}"),
        (OfDistance, "{\"mask\": \"\"}", "{\"mask\": \"\"}"),
        (OfDistance, "{\"mask\": 1}", "{\"mask\": 1}"),
        (OfDistance, "{\"mask\": \"xx\"}", "{\"mask\": \"..\"}"),
        (OfPack, "{\"cells\": \"x\"}", "{\"cells\": \"x\"}")
      ]
    )
  ]
