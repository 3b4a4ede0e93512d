-- | @pra-tactile compare@: an answer of @decode@ beside the truth that @probe@ wrote.
module Command.Compare
  ( command,
  )
where

import Control.Monad (guard)
import ExitStatus
import FormatFile
import Options
import PlacementChoice
import PraTactile.Explore
import PraTactile.Format (ObjectPose (..), encodeComparison)
import PraTactile.Object.Placement
import PraTactile.Object.WingedEdge
import PraTactile.Pose (movedBy, poseApart, scaledMotion, thenMotion)
import PraTactile.Recognise (leastSkew)
import PraTactile.Recognise.Summary (orientationText, upperLeftVertex)
import PraTactile.Symmetry (Symmetry, degreesClockwise)
import PraTactile.Truth
import Text.Printf (printf)

command :: Subcommand
command =
  subcommand
    "compare"
    "Compare an answer of 'decode' with the truth"
    "Compare an answer with the truth: whether the window's centre is where the answer says, and \
    \how many millimetres apart they are."
    []
    [ "pra-tactile probe --object cube --seed 7 --output frames --truth truth.json",
      "pra-tactile decode --json frames > answer.json",
      "pra-tactile compare answer.json truth.json"
    ]
    ( run
        <$> placementChoice "Take them from a database that 'objects --write' made"
        <*> pathArgument (metavar "ANSWER" <> help "A file with one answer of 'decode --json'")
        <*> pathArgument
          ( metavar "TRUTH"
              <> help "The file that 'probe --truth' wrote; the two files may be exchanged"
          )
        <*> jsonSwitch "Print the comparison as JSON"
    )

run :: PlacementChoice -> FilePath -> FilePath -> AnswerForm -> IO ExitStatus
run choice answerFile truthFile form = do
  ((told, posed), known) <- readAnswerAndTruth answerFile truthFile
  (scale, layout) <- shownWith choice (faceObject (truthFace known)) >>= feltPlacement . snd
  let larger = fromRational scale
      claim = scaledClaim (1 / larger) <$> told
      begunAlike = maybe id (truthFrom layout . claimFace) claim
      truth = begunAlike (scaledTruth (1 / larger) known)
      -- The window's centre, as the answer has it in the robot's frame.
      poses = do
        ObjectPose object pose world <- posed
        (x, y) <- claimSeenAt <$> told
        true <- scaledMotion larger <$> truePose layout truth
        -- The truth is in the robot's frame, the answer perhaps in the world.
        let there = maybe id (flip thenMotion) world true
        guard (object == faceObject (truthFace truth))
        Just (poseApart there pose (maybe id movedBy world [x, y, 0]))
      verdict = maybe (Left Nothing) (either (Left . Just) Right . compared layout truth) claim
  printAs
    form
    ( unlines
        ( comparison larger truth claim
            ++ poseText poses
            ++ [verdictText (farther larger verdict)]
        )
    )
    (encodeComparison larger truth claim verdict poses)
  pure (either (const NotAnswered) (const Answered) verdict)

-- | How far the pose is off, if there is one.
poseText :: Maybe (Double, Double) -> [String]
poseText poses =
  [ printf "the pose is off by %.2f mm there and by %.2f degrees" far angle
    | Just (far, angle) <- [poses]
  ]

-- | A verdict with its distances multiplied by a factor.
farther :: Double -> Either (Maybe Difference) Double -> Either (Maybe Difference) Double
farther k verdict = case verdict of
  Right far -> Right (k * far)
  Left (Just (Elsewhere far)) -> Left (Just (Elsewhere (k * far)))
  other -> other

verdictText :: Either (Maybe Difference) Double -> String
verdictText verdict = case verdict of
  Right far -> printf "they agree to %.2f mm" far
  Left Nothing -> "there is no answer to compare: it names no place on a face"
  Left (Just OtherFace) -> "they differ: it is another face"
  Left (Just OtherWayUp) -> "they differ: the face lies another way up"
  Left (Just (Elsewhere far)) -> printf "they differ: by %.2f mm" far

-- | The truth and the answer, in the same terms.
comparison :: Double -> Truth -> Maybe Claim -> [String]
comparison larger truth claim =
  ( "truth     "
      ++ faceWords (truthFace truth)
      ++ ", "
      ++ turnWords (regionSymmetry region) (Just (regionTurn region))
  ) :
  ( "          the region's upper left corner: "
      ++ spotWords (truthFace truth) (inMillimetres (regionCorner region))
  ) :
  concat
    [ ( "          what the composite shows as the window's centre: "
          ++ spotWords (truthFace truth) (inMillimetres (truePlace truth (claimSeenAt said)))
      ) :
      [ "answer    " ++ faceWords (claimFace said) ++ ", "
          ++ turnWords (claimSymmetry said) (claimAngle said),
        "          the window's centre: "
          ++ spotWords (claimFace said) (inMillimetres (claimPlace said))
      ]
      | Just said <- [claim]
    ]
  where
    inMillimetres (x, y) = (larger * x, larger * y)
    region = truthRegion truth
    faceWords face = objectText (faceObject face) ++ ", face " ++ faceText (faceName face)

-- | How a face lies: by its angle, if that is known and differs from the quarter turn.
turnWords :: Symmetry -> Maybe Double -> String
turnWords symmetry angle = case angle of
  Just degrees
    | abs (beyond degrees) > leastSkew -> printf "turned by %.1f degrees" degrees
  _ -> orientationText symmetry
  where
    -- From -180 to 180.
    beyond degrees = degrees - degreesClockwise symmetry - 360 * turns degrees
    turns degrees =
      fromInteger (round ((degrees - degreesClockwise symmetry) / 360)) :: Double

-- | A spot on a face in words.
spotWords :: Face -> (Double, Double) -> String
spotWords face (x, y) =
  printf "%.2f mm to the right of and %.2f mm below %s" x y (upperLeftVertex face)
