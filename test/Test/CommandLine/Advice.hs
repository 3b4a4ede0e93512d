-- | What messages advise does what it says: each is provoked, and followed to its end. The advice
-- of 'decode' about axes, scales and shades is followed by "Test.Recognition.TakenOtherwise", that
-- on tolerances of 'place' by "Test.CommandLine.Place".
module Test.CommandLine.Advice (spec) where

import Data.Foldable (for_)
import Data.List (isInfixOf)
import Test.CommandLine.Run
import Test.Hspec hiding (after, before)
import Test.Support

spec :: Spec
spec =
  for_ advised $ \(command, advice, followed) ->
    it (takeWhile (/= ' ') command ++ ": " ++ advice) . inFolder $ \folder -> do
      (before, said, err) <- scripted folder ("pra " ++ command)
      (before > 0, advice `isInfixOf` unwords (words (said ++ err))) `shouldBe` (True, True)
      -- What was said is there for an option to be taken out of it.
      writeFile (folder ++ "/said") (said ++ err)
      (after, _, _) <- scripted folder ("pra " ++ followed)
      after `shouldBe` 0

-- | A command, what it advises, and the command that follows it.
advised :: [(String, String, String)]
advised =
  [ ( "array --q 2 --polynomial 1,1,0,0,1 --shape 5x3",
      "give --window ROWSxCOLUMNS",
      "array --q 2 --polynomial 1,1,0,0,1 --shape 5x3 --window 2x2"
    ),
    ( "locate --road table '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2",
      "leave out --road",
      "locate '[[[0,0,0.1,0.9], 2], [3, 1]]' --doubt 0.2"
    ),
    ("locate '3 2'", "ambiguous", "locate '3 2 / 3 1'"),
    ( "solid box:5x5x5 --output inches.obj > log; pra place inches.obj",
      "is the file in inches? give --scale 25.4",
      "place inches.obj $(grep -o -- '--scale [0-9.]*' said)"
    ),
    ( "solid tetrahedron:100 --output t.off > log; "
        ++ "sed 's/^3 0 1 2$/3 0 2 1/' t.off > turned.off; pra solid turned.off",
      "with --fix-orientation it would be a solid",
      "solid turned.off --fix-orientation"
    ),
    ( "solid pyritohedron:100/3 --output round.obj > log; pra solid round.obj",
      "it would be a solid",
      "solid round.obj $(grep -o -- '--tolerance [0-9.]*' said)"
    ),
    ( "objects --database none.db",
      "'pra-tactile objects --write FILE' makes one",
      "objects --write none.db && pra objects --database none.db"
    ),
    ( "objects --write made.db > log; pra objects --add cube --database made.db",
      "--replace puts another in its place",
      "objects --replace cube --database made.db"
    ),
    ( "emboss --object cube --face 'C1 C2 C3 C4' --thickness 0.1 --output top.stl",
      "a plate of 0.1 mm is not thicker than that: choose another --thickness",
      "emboss --object cube --face 'C1 C2 C3 C4' --thickness 4 --output top.stl"
    ),
    ( "emboss --net --page 100x100 --object cube --output pages",
      "choose a larger --page",
      "emboss --net --page 297x420 --object cube --output pages"
    ),
    ( "emboss --object cube --output part.txt",
      "ends in none of .stl, .obj, .3mf, .json, .svg",
      "emboss --object cube --output part.3mf"
    ),
    ( "probe --object cube --seed 1 --size 100x100 --at 100,100 --output frames",
      "does not lie on the face C6 C5 C8 C7, which is 127 x 127 mm; choose another --size or --at",
      "probe --object cube --seed 1 --size 60x60 --at 10,10 --output frames"
    ),
    ( "probe --object cube --seed 7 --output frames > log; "
        ++ "pra segment frames --no-stitching --position-error 1",
      "leave out --position-error",
      "segment frames --no-stitching"
    )
  ]
